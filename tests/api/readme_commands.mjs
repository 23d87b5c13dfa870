// The curl commands of the README, each with the JSON that follows it.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";

/// The words of a command, as a shell divides them.
function wordsOf(command) {
  const words = command.replaceAll("\\\n", " ").matchAll(/(?:'[^']*'|[^\s'])+/g);
  return [...words].map(([word]) => word.replaceAll("'", ""));
}

function form(fields) {
  const boundary = "readme-commands";
  const parts = fields.map(({ name, fileName, content }) => Buffer.concat([
    Buffer.from(`--${boundary}\r\nContent-Disposition: form-data; name="${name}"` +
      `${fileName ? `; filename="${fileName}"` : ""}\r\n\r\n`), content, Buffer.from("\r\n")]));
  return { type: `multipart/form-data; boundary=${boundary}`,
    body: Buffer.concat([...parts, Buffer.from(`--${boundary}--\r\n`)]) };
}

/// The request that a command sends; files are read from `root`.
function requestOf(command, root) {
  const read = (name) => fs.readFileSync(path.join(root, name));
  const [, ...words] = wordsOf(command);
  const headers = {}, fields = [];
  let body, url;
  while (words.length > 0) {
    const word = words.shift();
    if (word === "-H") {
      const [, name, value] = words.shift().match(/^([^:]+): *(.*)$/);
      headers[name.toLowerCase()] = value;
    } else if (word === "--data-binary") {
      body = read(words.shift().slice(1));
    } else if (word === "-F") {
      const [, name, value] = words.shift().match(/^([^=]+)=([^]*)$/);
      fields.push(value.startsWith("@")
        ? { name, fileName: path.basename(value), content: read(value.slice(1)) }
        : { name, content: Buffer.from(value) });
    } else {
      assert.match(word, /^http:/, `an option that this test does not know: ${word}`);
      url = new URL(word);
    }
  }
  if (fields.length > 0) {
    const { type, body: content } = form(fields);
    headers["content-type"] = type;
    body = content;
  }
  return { method: "POST", path: url.pathname, query: Object.fromEntries(url.searchParams), headers, body };
}

/// Each curl command: its request, and the text up to the next one.
export function readmeCommands(root) {
  const readme = fs.readFileSync(path.join(root, "README.md"), "utf8");
  return readme.split("\n```sh\n").slice(1).filter((part) => part.startsWith("curl ")).map((part) => {
    const end = part.indexOf("\n```\n");
    return { wanted: requestOf(part.slice(0, end), root), text: part.slice(end + 4) };
  });
}

/// The first block of a language in a text.
export function blockOf(text, language) {
  return text.match(new RegExp(`\n\`\`\`${language}\n([^]*?)\n\`\`\`\n`))?.[1];
}

/// The rows of the table of the real file, which is no part of the repository.
export function realFileRows(root) {
  const readme = fs.readFileSync(path.join(root, "README.md"), "utf8");
  const row = new RegExp("^\\| `([\\w-]+)`(?:, `theta_x_deg` (\\d+))? \\| ([\\d.]+)° \\| ([\\d.]+) of ([\\d.]+)°/s " +
    "\\| (\\d+) \\| ([\\d.]+) s \\|", "gm");
  return [...readme.matchAll(row)].map(([, machine, ...numbers]) => {
    const [theta, closest, peak, limit, zones, lost] = numbers.map(Number);
    return { machine, theta: theta || 0, closest, peak, limit, zones, lost };
  });
}

/// The rows of the table of machines compared.
export function comparedRows(root) {
  const readme = fs.readFileSync(path.join(root, "README.md"), "utf8");
  const row = /^\| `([\w-]+)` \| (all|some) \| ([\d.]+) s \| ([\d.]+) \((\w+)\) \| (\d+) \| (\d+) \|$/gm;
  return [...readme.matchAll(row)].map(([, name, known, time, ratio, axis, zones, others]) =>
    [name, known, time, ratio, axis, Number(zones), Number(others)]);
}

/// The rows of the table of real files clamped anew. `before` is undefined where a refusal stands.
export function reorientedRows(root) {
  const readme = fs.readFileSync(path.join(root, "README.md"), "utf8");
  const row = new RegExp("^\\| `([\\w.-]+)` \\| `([\\w-]+)` \\| (\\d+) \\| (?:`(\\w+)`|([\\d.]+)°) → ([\\d.]+)° " +
    "\\| (?:–|([\\d.]+)) → ([\\d.]+) \\| (?:–|([\\d.]+)) → ([\\d.]+) s \\| ([-\\d.]+)°, ([-\\d.]+)° \\|$", "gm");
  return [...readme.matchAll(row)].map(([, file, machine, tilt, refusal, near, best, ratio, bestRatio, time, bestTime, x, z]) => ({
    file, machine, tilt: Number(tilt), refusal,
    before: refusal ? undefined : [near, ratio, time].map(Number), after: [best, bestRatio, bestTime, x, z].map(Number) }));
}

/// Throws where what is shown is not in the answer. Numbers are shown rounded.
export function holdShown(shown, real, place) {
  if (typeof shown === "number") {
    assert.ok(Math.abs(shown - real) < 1e-4, `${place}: ${real}`);
  } else if (shown !== null && typeof shown === "object") {
    assert.equal(typeof real, "object", place);
    if (Array.isArray(shown)) assert.equal(real.length, shown.length, `${place}: length`);
    for (const name of Object.keys(shown)) holdShown(shown[name], real[name], `${place}/${name}`);
  } else {
    assert.equal(shown, real, place);
  }
}
