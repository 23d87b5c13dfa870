// Holds every answer of a running server against api/openapi.yaml.
//   node contract.mjs PENTAPOST            checks; ends with 1 where an answer breaks the contract
//   node contract.mjs PENTAPOST --update   also writes the answers into api/examples/*.json
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { Contract } from "./contract_document.mjs";
import { blockOf, holdShown, readmeCommands, realFileRows } from "./readme_commands.mjs";
import { open, request, start } from "./running_server.mjs";

const here = path.dirname(fileURLToPath(import.meta.url));
const root = path.resolve(here, "../..");
const [binary, ...flags] = process.argv.slice(2);
const update = flags.includes("--update");
const contract = new Contract(path.join(root, "api"));
let failures = 0;

async function check(title, run) {
  try {
    await run();
    console.log(`ok      ${title}`);
  } catch (error) {
    failures += 1;
    console.log(`FAILED  ${title}\n        ${error.message.replaceAll("\n", "\n        ")}`);
  }
}

/// Sends one request and holds the answer against the document.
async function held(port, wanted, status) {
  const answer = await request(port, wanted);
  if (status !== undefined)
    assert.equal(answer.status, status, `status ${answer.status}: ${answer.text.slice(0, 300)}`);
  contract.check(wanted, answer);
  return answer;
}

const job = (body, more = {}) => ({
  method: "POST", path: "/post", headers: { "content-type": "application/json" },
  body: typeof body === "string" ? body : JSON.stringify(body), ...more,
});
const text = (query, body, headers = {}) => ({
  method: "POST", path: "/post", query, headers: { "content-type": "text/plain", ...headers }, body,
});

async function checkReading(port) {
  const names = (await held(port, { path: "/machines" }, 200)).json.machines.map((m) => m.name);
  assert.ok(names.length > 0, "there are no machines");
  for (const name of names) {
    await check(`GET /machines/${name}, its bytes, its tag, and back as an inline machine`, async () => {
      const answer = await held(port, { path: `/machines/${name}` }, 200);
      const { version } = answer.json;
      const pinned = await held(port, { path: `/machines/${name}/versions/${version}` }, 200);
      assert.deepEqual(pinned.bytes, fs.readFileSync(path.join(root, "machines", name, `${version}.json`)));
      const known = { "if-none-match": answer.headers.etag };
      assert.equal((await held(port, { path: `/machines/${name}`, headers: known }, 304)).bytes.length, 0);
      const inline = await held(port, job({ machine: answer.json, cl: "" }), 400);
      assert.equal(inline.json.code, "no_motion");
    });
  }
  for (const place of ["/machines", "/dialects", "/healthz", "/version", "/openapi.yaml",
    "/schemas/machine.schema.json"]) {
    await check(`GET and HEAD ${place}, and 406`, async () => {
      const whole = await held(port, { path: place }, 200);
      const head = await held(port, { method: "HEAD", path: place }, 200);
      assert.equal(head.headers["content-length"], String(whole.bytes.length));
      assert.equal(head.bytes.length, 0);
      await held(port, { path: place, headers: { accept: "image/png" } }, 406);
    });
  }
  await check("GET /openapi.yaml is this document", async () => {
    const answer = await held(port, { path: "/openapi.yaml" }, 200);
    assert.deepEqual(answer.bytes, fs.readFileSync(path.join(root, "api/openapi.yaml")));
  });
}

/// What is wrong with a job, where, and that it is the client's to mend.
async function checkPlaces(port) {
  const cl = "UNITS/MM\nLOADTL/1\nFEDRAT/1000,MMPM\nGOTO/0,0,50,0,0,1\nGOTO/9,0,50,0,0,1\nFINI\n";
  const machine = (await held(port, { path: "/machines/hermle-c600u" }, 200)).json;
  const changed = (change) => {
    const copy = structuredClone(machine);
    change(copy);
    return job({ machine: copy, cl });
  };
  const options = (value) => changed((copy) => { copy.controller.options = value; });
  const named = { machine: "hermle-c600u" };
  const places = [
    ["a body that is no object", job("[]"), 400, "wrong_type", "", /an array.*expected an object/],
    ["no machine", job({ cl }), 400, "missing_key", "/machine", /machine/],
    ["no path", job(named), 400, "missing_key", "/cl", /cl and path/],
    ["cl and path", job({ ...named, cl, path: { feed_mm_min: 1, points: [[0, 0, 0, 0, 0, 1]] } }), 400,
      "conflicting_keys", "/path", /exactly one/],
    ["an unknown query key", text({ ...named, tip: "1" }, cl), 400, "unknown_key", "/tip", /tip/],
    ["a huge tolerance", job({ ...named, cl, tolerances: { tip_mm: 1000 } }), 400, "out_of_domain",
      "/tolerances/tip_mm", /1000.*at most 1$/],
    ["a huge tolerance in the query", text({ ...named, axis_deg: "360" }, cl), 400, "out_of_domain",
      "/tolerances/axis_deg", /360.*at most 5$/],
    ["a tolerance below the digits", job({ ...named, cl, tolerances: { tip_mm: 1e-6 } }), 422,
      "tolerance_below_digits", "/tolerances/tip_mm", /1e-06/],
    ["a reversed range", changed((copy) => { copy.axes.A.range_deg = [90, -90]; }), 422,
      "definition_meaning", "/machine/axes/A/range_deg", /90, -90/],
    ["an option that changes the mode", options({ start_lines: ["G91"] }), 422, "not_in_dialect",
      "/machine/controller/options/start_lines", /NC text line/],
    ["an option with an unknown placeholder", options({ tcp_on: ["M128 {foo}"] }), 422, "bad_option",
      "/machine/controller/options/tcp_on", /\{foo\}/],
    ["an unknown option", options({ decimal_mm: 3 }), 422, "bad_option",
      "/machine/controller/options/decimal_mm", /decimals_mm/],
  ];
  for (const [title, wanted, status, code, pointer, detail] of places) {
    await check(`${status} ${code} at "${pointer}": ${title}`, async () => {
      const { json } = await held(port, wanted, status);
      assert.deepEqual([json.code, json.pointer], [code, pointer]);
      assert.match(json.detail, detail);
    });
  }
}

/// What POST /analyse refuses beside what POST /post does.
async function checkAnalyse(port) {
  const cl = "UNITS/MM\nFEDRAT/MMPM,600\nGOTO/0,0,0\nGOTO/9,0,0\n";
  const query = { machine: "generic-3axis" };
  const refusals = [
    ["a share of 0", text({ ...query, zone_share: "0" }, cl), 400, "out_of_domain", "/zone_share"],
    ["a share that is no number", text({ ...query, zone_share: "x" }, cl), 400, "out_of_domain", "/zone_share"],
    ["an unknown key", text({ ...query, share: "1" }, cl), 400, "unknown_key", "/share"],
    ["an unknown machine", text({ machine: "hermle" }, cl), 404, "unknown_machine", "/machine"],
    ["text for an answer", text(query, cl, { accept: "text/plain" }), 406, "not_acceptable", undefined],
    ["another content type", text(query, cl, { "content-type": "application/xml" }), 415,
      "unsupported_media_type", undefined],
    ["cl and nc", job({ ...query, cl, nc: "%" }), 400, "conflicting_keys", "/cl"],
    ["path and nc", job({ ...query, path: { feed_mm_min: 1, points: [[0, 0, 0, 0, 0, 1]] }, nc: "%" }), 400,
      "conflicting_keys", "/path"],
    ["max_samples without samples", job({ ...query, cl, max_samples: 200 }), 400, "conflicting_keys", "/max_samples"],
    ["too few samples", job({ ...query, cl, samples: true, max_samples: 99 }), 400, "out_of_domain", "/max_samples"],
    ["too many samples", job({ ...query, cl, samples: true, max_samples: 100_001 }), 400, "out_of_domain",
      "/max_samples"],
    ["a change of the tool axis above 5 degrees", job({ ...query, cl, post: { pole_axis_deg: 5.1 } }), 400,
      "out_of_domain", "/post/pole_axis_deg"],
    ["a changed tool axis in a flank cut", job({ ...query, cl, post: { flank: true, pole_axis_deg: 1 } }), 400,
      "conflicting_keys", "/post/pole_axis_deg"],
    ["a turned setup with nc", job({ ...query, nc: "%", setup: { theta_x_deg: 5 } }), 400,
      "conflicting_keys", "/setup/theta_x_deg"],
    ["a dialect of nc without nc", job({ ...query, cl, nc_dialect: "fanuc-30i" }), 400,
      "conflicting_keys", "/nc_dialect"],
    ["an unknown dialect of nc", job({ ...query, nc: "%", nc_dialect: "x" }), 422, "unknown_dialect",
      "/nc_dialect"],
    ["an NC program without motion", job({ ...query, nc: "%\nO1\nM30\n%\n", nc_dialect: "fanuc-30i" }), 400,
      "no_motion", "/nc"],
    ["a damaged NC program", job({ ...query, nc: "%\nO1\nG77 X1.\nM30\n%\n", nc_dialect: "fanuc-30i" }), 400,
      "damaged_block", "/nc"],
  ];
  for (const [title, wanted, status, code, pointer] of refusals) {
    await check(`POST /analyse ${status} ${code}: ${title}`, async () => {
      const { json } = await held(port, { ...wanted, path: "/analyse" }, status);
      assert.deepEqual([json.code, json.pointer], [code, pointer]);
    });
  }
  const nc = fs.readFileSync(path.join(root, "tests/data/papers/cripps-2017-appendix-2.nc"), "utf8");
  await check("POST /analyse of an NC program", async () => {
    const wanted = { ...job({ machine: "hermle-c600u", nc, nc_dialect: "heidenhain-iso" }), path: "/analyse" };
    const { json } = await held(port, wanted, 200);
    assert.equal(json.nc.dialect, "heidenhain-iso");
    assert.deepEqual([json.zones[0].from.tip_mm[0], json.zones[0].to.tip_mm[0]], [22, 28]);
    assert.equal(nc.split("\n")[json.zones[0].to.nc_line - 1].split(" ")[1], "X+28");
  });
  await check("POST /analyse of rapids alone: no samples", async () => {
    const wanted = job({ ...query, samples: true, cl: "UNITS/MM\nRAPID\nGOTO/0,0,0\nRAPID\nGOTO/9,0,0\n" });
    const { json } = await held(port, { ...wanted, path: "/analyse" }, 200);
    assert.equal(json.samples, undefined);
    assert.equal(json.summary.length_mm, 0);
  });
  await check("POST /post 400: nc", async () => {
    const { json } = await held(port, job({ machine: "hermle-c600u", nc }), 400);
    assert.deepEqual([json.code, json.pointer], ["unknown_key", "/nc"]);
  });
  await check("POST /post 400: zone_share in the query", async () => {
    const { json } = await held(port, text({ ...query, zone_share: "1" }, cl), 400);
    assert.deepEqual([json.code, json.pointer], ["unknown_key", "/zone_share"]);
  });
}

async function checkRefusals(port) {
  const cl = "GOTO/0,0,0\n";
  const refusals = [
    ["no JSON", job("{"), 400, "bad_json"],
    ["an empty body", job(""), 400, "bad_json"],
    ["a key that stands twice", job('{"machine":"generic-3axis","cl":"","cl":""}'), 400, "bad_json"],
    ["deep nesting", job("[".repeat(100_000)), 400, "bad_json"],
    ["an unknown key", job({ machine: "generic-3axis", cl, tolerance: 1 }), 400, "unknown_key"],
    ["a wrong type", job({ machine: 1, cl }), 400, "wrong_type"],
    ["a tolerance of 0", job({ machine: "generic-3axis", cl, tolerances: { tip_mm: 0 } }), 400, "out_of_domain"],
    ["no path", job({ machine: "generic-3axis" }), 400, "missing_key"],
    ["an empty CL file", text({ machine: "generic-3axis" }, ""), 400, "no_motion"],
    ["an unknown query key", text({ machine: "generic-3axis", tip: "1" }, cl), 400, "unknown_key"],
    ["an unknown machine", text({ machine: "hermle" }, cl), 404, "unknown_machine"],
    ["an unknown version", text({ machine: "generic-3axis@9.9.9" }, cl), 404, "unknown_version"],
    ["an unknown dialect", text({ machine: "generic-3axis", dialect: "x" }, cl), 422, "unknown_dialect"],
    ["an unknown CL dialect", job({ machine: "generic-3axis", cl, cl_dialect: "nx" }), 422, "unknown_dialect"],
    ["a definition that is none", job({ machine: { name: "x" }, cl }), 422, "definition_schema"],
    ["a form without a boundary", { method: "POST", path: "/post",
      headers: { "content-type": "multipart/form-data" }, body: "x" }, 400, "bad_form"],
    ["another content type", { ...job("{}"), headers: { "content-type": "application/xml" } }, 415,
      "unsupported_media_type"],
    ["another Accept", text({ machine: "generic-3axis" }, cl, { accept: "image/png" }), 406, "not_acceptable"],
    ["a body over the limit", job(`"${"x".repeat(1_100_000)}"`), 413, "body_too_large"],
    ["a chunked body over the limit", job(`"${"x".repeat(1_100_000)}"`, { chunked: true }), 413,
      "body_too_large"],
    ["a head over the limit", { path: "/healthz", headers: { "x-a": "a".repeat(20_000) } }, 431,
      "head_too_large"],
    ["another method", { method: "DELETE", path: "/machines" }, 405, "method_not_allowed"],
    ["another path", { path: "/reorient" }, 404, "not_found"],
    ["another schema", { path: "/schemas/x.json" }, 404, "not_found"],
    ["another machine", { path: "/machines/x" }, 404, "unknown_machine"],
    ["another version", { path: "/machines/generic-3axis/versions/9.9.9" }, 404, "unknown_version"],
  ];
  for (const [title, wanted, status, code] of refusals) {
    await check(`${status} ${code}: ${title}`, async () => {
      const answer = await held(port, wanted, status);
      assert.equal(answer.json.code, code);
      assert.equal(answer.json.status, status);
      if (status === 405) assert.equal(answer.headers.allow, "GET, HEAD");
    });
  }
  await check("400 to 100 kB of random bytes, and the server lives on", async () => {
    let state = 42;
    const bytes = Buffer.from(Array.from({ length: 100_000 }, () => {
      state = (Math.imul(state, 1_103_515_245) + 12_345) >>> 0;
      return state >>> 24;
    }));
    const answer = await held(port, text({ machine: "generic-3axis" }, bytes), 400);
    assert.ok(answer.json.detail.length > 0);
    await held(port, { path: "/healthz" }, 200);
  });
  await check("503 while as many jobs as the bound allows are under way", async () => {
    const holder = await open(port, "POST /post HTTP/1.1\r\nHost: a\r\nContent-Type: text/plain\r\n" +
      "Content-Length: 5\r\nExpect: 100-continue\r\n\r\n");
    try {
      const answer = await held(port, text({ machine: "generic-3axis" }, cl), 503);
      assert.equal(answer.json.code, "overloaded");
      assert.equal(answer.headers["retry-after"], "1");
    } finally {
      holder.destroy();
    }
  });
}

/// What the schema of a job refuses, the server refuses, and the reverse.
async function checkJobSchema(port) {
  const path = { feed_mm_min: 100, points: [[0, 0, 0, 0, 0, 1], [1, 0, 0, 0, 0, 1]] };
  const base = { machine: "generic-3axis", path };
  const variants = [
    {}, { tolerances: { tip_mm: 1.001 } }, { tolerances: { axis_deg: 5 } }, { tolerances: { axis_deg: 5.001 } },
    { setup: { theta_x_deg: 361 } }, { setup: { theta_z_deg: -360 } }, { tolerances: { tip_mm: 0 } }, { tolerances: { tip_mm: 1 } }, { tolerances: { tip: 1 } },
    { setup: { origin_mm: [0, 0] } }, { setup: { origin_mm: [0, 0, "0"] } }, { setup: { theta_x_deg: 5 } },
    { setup: { origin_mm: [0, 0, 2e6] } }, { tools: { 1: { gauge_length_mm: 2e6 } } },
    { setup: [] }, { tools: { 1: { gauge_length_mm: -1 } } }, { tools: { "01": {} } }, { tools: { a: {} } },
    { tools: { 1: { gauge_length_mm: 100 } } }, { post: { output: "tcp" } }, { post: { output: "joints" } },
    { post: { dialect: null } }, { post: { flank: 1 } },
    { post: { pole_axis_deg: 0 } }, { post: { pole_axis_deg: 5 } }, { post: { pole_axis_deg: 5.001 } }, { post: { pole_axis_deg: -1 } },
    { post: { flank: true, pole_axis_deg: 0 } }, { post: { flank: true, pole_axis_deg: 1 } }, { post: { flank: false, pole_axis_deg: 1 } }, { post: { prefer: { tilt: "up" } } },
    { post: { prefer: { first_turn_deg: [0] } } }, { limits: { X: { max_speed_mm_s: 0 } } },
    { limits: { X: { max_speed_mm_s: 10 } } }, { limits: { X: 5 } }, { cl: "" }, { cl_units: "cm" },
    { dual_nurbs: {} }, { nc: "" }, { path: { feed_mm_min: 0, points: path.points } },
    { path: { points: path.points } }, { path: { ...path, points: [[0, 0, 0, 0, 0]] } },
    { path: { ...path, points: [] } }, { path: { ...path, more: 1 } }, { machine: 5 }, { machine: null },
  ];
  const ofAnalysis = [
    ...[0, -1, 1e-3, 2.5, "1"].map((zone_share) => ({ zone_share })),
    ...[99, 100, 100_000, 100_001, 150.5, "200"].map((max_samples) => ({ samples: true, max_samples })),
    { samples: true }, { samples: false }, { samples: 1 }, { samples: false, max_samples: 200 }, { max_samples: 200 },
    { nc: "%" }, { nc_dialect: "fanuc-30i" }, { post: { zone_comments: true } }, { post: { zone_comments: 1 } },
    { post: { pole_axis_deg: 5 } }, { post: { pole_axis_deg: 5.1 } }, { post: { flank: true, pole_axis_deg: 1 } },
  ];
  const all = [...variants.map((variant) => ["/post", variant]),
    ...["/post", "/analyse"].flatMap((place) => ofAnalysis.map((variant) => [place, variant]))];
  for (const [place, variant] of all) {
    const body = { ...base, ...variant };
    await check(`${place}: the schema and the server agree on ${JSON.stringify(variant).slice(0, 60)}`, async () => {
      const answer = await held(port, job(body, { path: place }));
      assert.equal(answer.status !== 400, contract.isJob(body, place), answer.text.slice(0, 300));
    });
  }
}

/// What differs from run to run is not compared.
function comparable(answer) {
  const content = answer.json ?? answer.text;
  if (content && typeof content === "object" && "request_id" in content) content.request_id = "...";
  return content;
}

/// `real`, with the numbers of `shown` where they differ by their last digits alone: those may
/// change with compiler and processor.
function rounded(real, shown) {
  if (typeof real === "number" && typeof shown === "number")
    return Math.abs(real - shown) <= 1e-9 * Math.abs(shown) + 1e-12 ? shown : real;
  if (real === null || shown === null || typeof real !== "object" || typeof shown !== "object") return real;
  if (Array.isArray(real)) return real.map((value, i) => rounded(value, shown[i]));
  return Object.fromEntries(Object.entries(real).map(([key, value]) => [key, rounded(value, shown[key])]));
}

/// Numbers of an array share a line. No string has a line end inside.
function exampleText(example) {
  const number = "(?:[-+.\\dEe]+|null|true|false)";
  const numbers = new RegExp(`\\[\\s*\\n\\s*(${number}(?:,\\n\\s*${number})*)\\n\\s*\\]`, "g");
  return JSON.stringify(example, null, 2).replace(numbers, (_, inner) => `[${inner.replace(/\s+/g, " ")}]`) + "\n";
}

async function checkExamples(port) {
  const folder = path.join(root, "api/examples");
  for (const name of fs.readdirSync(folder).filter((file) => file.endsWith(".json")).sort()) {
    await check(`api/examples/${name}`, async () => {
      const file = path.join(folder, name);
      const example = JSON.parse(fs.readFileSync(file, "utf8"));
      const wanted = { ...example.request };
      if (wanted.json !== undefined) {
        assert.equal(contract.isJob(wanted.json, wanted.path), example.answer.status !== 400, "the job and its schema");
        wanted.body = JSON.stringify(wanted.json);
      }
      if (Array.isArray(wanted.body)) wanted.body = wanted.body.join("\n") + "\n";
      const answer = await held(port, wanted, example.answer.status);
      const seen = { status: answer.status, content_type: answer.headers["content-type"],
        content: comparable(answer) };
      if (update) fs.writeFileSync(file, exampleText({ ...example, answer: seen }));
      else assert.deepEqual(rounded(seen, example.answer), example.answer);
    });
  }
}

/// The README's commands: what it prints of their answers. The first one prints a program too.
async function checkReadme(port) {
  const [first, ...others] = readmeCommands(root);
  const asJson = { ...first.wanted, headers: { ...first.wanted.headers, accept: "application/json" } };
  await check("the NC program in the README", async () => {
    const { nc } = (await held(port, asJson, 200)).json;
    assert.equal((await held(port, first.wanted, 200)).text, nc);
    let rest = `\n${nc}`;
    for (const part of blockOf(first.text, "nc").split("\n…\n")) {
      const place = rest.indexOf(`\n${part}\n`);
      assert.ok(place >= 0, `not in the program, or not in this order:\n${part}`);
      rest = rest.slice(place + part.length);
    }
  });
  await check("the report in the README", async () => {
    const { report } = (await held(port, asJson, 200)).json;
    holdShown(JSON.parse(blockOf(first.text, "json")), report, "");
  });
  for (const { wanted, text: after } of others) {
    await check(`the answer of ${wanted.path} in the README`, async () => {
      const { json } = await held(port, wanted, 200);
      holdShown(JSON.parse(blockOf(after, "json")), json, "");
    });
  }
}

/// The README's table of a real file, where that file is.
async function checkRealFile(port) {
  const file = path.join(root, "../shared/data/cl/nx-five-axis-inch.cls");
  if (!fs.existsSync(file)) return console.log("skipped the README's real file: it is not here");
  const cl = fs.readFileSync(file, "utf8");
  await check("the table of a real file in the README", async () => {
    const rows = realFileRows(root);
    assert.equal(rows.length, 4);
    for (const row of rows) {
      const wanted = job({ machine: row.machine, cl, setup: { theta_x_deg: row.theta } }, { path: "/analyse" });
      const { summary, axes, zones } = (await held(port, wanted, 200)).json;
      const near = (shown, real, tolerance) => assert.ok(Math.abs(shown - real) <= tolerance, `${shown}: ${real}`);
      near(row.closest, summary.closest_approach_deg, 0.005);
      near(row.peak, axes.C.peak_deg_s, 0.05);
      near(row.limit, axes.C.limit_deg_s, 1e-9);
      near(row.lost, summary.predicted_time_s - summary.programmed_time_s, 0.005);
      assert.equal(zones.length, row.zones);
    }
  });
}

const server = await start(binary, ["--body-limit-mib", "1", "--threads", "1", "--queue", "0"], root);
try {
  await checkReading(server.port);
  await checkRefusals(server.port);
  await checkPlaces(server.port);
  await checkAnalyse(server.port);
  await checkJobSchema(server.port);
  await checkExamples(server.port);
  await checkReadme(server.port);
  await checkRealFile(server.port);
} finally {
  const code = await server.stop();
  await check("SIGTERM ends the server with 0", () => assert.equal(code, 0));
}
await check("every operation of the document was called", () => assert.deepEqual(contract.uncalled(), []));
process.exitCode = failures === 0 ? 0 : 1;
