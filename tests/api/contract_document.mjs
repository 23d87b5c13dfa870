// The OpenAPI document as something to hold answers against.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import Ajv2020 from "ajv/dist/2020.js";
import addFormats from "ajv-formats";
import YAML from "yaml";

const base = "https://contract.invalid/openapi.yaml";
const escaped = (key) => key.replaceAll("~", "~0").replaceAll("/", "~1");
const mediaTypeOf = (header) => (header ?? "").split(";")[0].trim().toLowerCase();

export class Contract {
  #document;
  #ajv;
  #called = new Set();

  constructor(folder) {
    this.#document = YAML.parse(fs.readFileSync(path.join(folder, "openapi.yaml"), "utf8"));
    this.#ajv = new Ajv2020.default({ strict: false, allErrors: false });
    addFormats.default(this.#ajv);
    for (const file of fs.readdirSync(path.join(folder, "schemas"))) {
      const schema = JSON.parse(fs.readFileSync(path.join(folder, "schemas", file), "utf8"));
      delete schema.$schema;
      this.#ajv.addSchema({ ...schema, $id: new URL(`schemas/${file}`, base).href });
    }
    this.#ajv.addSchema({ ...this.#document, $id: base });
  }

  /// Whether the operation at that path takes the job.
  isJob(body, place) {
    const { schema } = this.#document.paths[place].post.requestBody.content["application/json"];
    return this.#validator(schema.$ref)(body);
  }

  /// Throws where the document does not have such an answer to the request.
  check(wanted, answer) {
    const id = answer.headers["x-request-id"];
    assert.ok(id?.length >= 1 && id.length <= 128, "X-Request-Id");
    assert.ok(!Number.isNaN(Date.parse(answer.headers.date)), "Date");
    const operation = this.#operationOf(wanted);
    if (operation === undefined || [400, 408, 431].includes(answer.status)) return this.#checkProblem(answer);
    this.#called.add(operation.id);
    const [response, pointer] = this.#followed(operation.value.responses[answer.status],
      `${operation.pointer}/responses/${answer.status}`);
    assert.ok(response, `status ${answer.status} is not in the document for ${operation.id}`);
    for (const [name, header] of Object.entries(response.headers ?? {})) {
      const [definition, place] = this.#followed(header, `${pointer}/headers/${escaped(name)}`);
      const value = answer.headers[name.toLowerCase()];
      assert.ok(value !== undefined || !definition.required, `the header ${name} is missing`);
      const typed = definition.schema.type === "integer" ? Number(value) : value;
      if (value !== undefined) this.#hold(`${place}/schema`, typed);
    }
    if (answer.status >= 400) this.#checkProblem(answer);
    if (wanted.method === "HEAD" || response.content === undefined) return;
    const type = mediaTypeOf(answer.headers["content-type"]);
    assert.ok(type in response.content, `the document has no ${type} for ${answer.status}`);
    this.#hold(`${pointer}/content/${escaped(type)}/schema`, answer.json ?? answer.text);
  }

  uncalled() {
    const all = Object.entries(this.#document.paths).flatMap(([place, item]) =>
      Object.keys(item).map((method) => `${method} ${place}`));
    return all.filter((operation) => !this.#called.has(operation));
  }

  #checkProblem(answer) {
    if (answer.bytes.length === 0 && answer.status < 400) return;
    assert.equal(mediaTypeOf(answer.headers["content-type"]), "application/problem+json");
    this.#hold("#/components/schemas/Problem", answer.json);
    assert.equal(answer.json.request_id, answer.headers["x-request-id"]);
  }

  #operationOf({ method = "GET", path: place }) {
    const name = (method === "HEAD" ? "GET" : method).toLowerCase();
    for (const [pattern, item] of Object.entries(this.#document.paths)) {
      const expression = new RegExp(`^${pattern.replaceAll(".", "\\.").replace(/\{\w+\}/g, "[^/]+")}$`);
      if (!expression.test(place) || !(name in item)) continue;
      return { id: `${name} ${pattern}`, value: item[name], pointer: `#/paths/${escaped(pattern)}/${name}` };
    }
    return undefined;
  }

  #followed(value, pointer) {
    if (!value?.$ref?.startsWith("#/")) return [value, pointer];
    const target = value.$ref.slice(2).split("/").reduce((node, key) => node[key], this.#document);
    return [target, value.$ref];
  }

  #validator(pointer) {
    const reference = base + pointer.replaceAll("{", "%7B").replaceAll("}", "%7D");
    return this.#ajv.getSchema(reference) ?? this.#ajv.compile({ $ref: reference });
  }

  #hold(pointer, value) {
    const validate = this.#validator(pointer);
    assert.ok(validate(value), `${pointer}: ${this.#ajv.errorsText(validate.errors)}`);
  }
}
