// Holds every answer of a running server against api/openapi.yaml.
//   node contract.mjs PENTAPOST            checks; ends with 1 where an answer breaks the contract
//   node contract.mjs PENTAPOST --update   also writes the answers into api/examples/*.json
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { Contract } from "./contract_document.mjs";
import { blockOf, comparedRows, holdShown, readmeCommands, realFileRows, reorientedRows } from "./readme_commands.mjs";
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

/// What POST /reorient refuses beside what POST /post does, and that its setup posts.
async function checkReorient(port) {
  const cl = "UNITS/MM\nFEDRAT/MMPM,600\nGOTO/0,0,0,0,0.6,0.8\nGOTO/9,0,0,0,0.8,0.6\n";
  const query = { machine: "hermle-c600u" };
  const refusals = [
    ["an unknown objective", text({ ...query, objective: "speed" }, cl), 400, "out_of_domain", "/objective"],
    ["a negative tilt", text({ ...query, max_tilt_deg: "-1" }, cl), 400, "out_of_domain", "/max_tilt_deg"],
    ["an accuracy of 6 degrees", text({ ...query, setup_accuracy_deg: "6" }, cl), 400, "out_of_domain",
      "/setup_accuracy_deg"],
    ["a word of /analyse", text({ ...query, zone_share: "1" }, cl), 400, "unknown_key", "/zone_share"],
    ["text for an answer", text(query, cl, { accept: "text/plain" }), 406, "not_acceptable", undefined],
    ["another content type", text(query, cl, { "content-type": "application/xml" }), 415,
      "unsupported_media_type", undefined],
    ["an unknown machine", text({ machine: "hermle" }, cl), 404, "unknown_machine", "/machine"],
    ["an NC program", job({ ...query, nc: "%" }), 400, "unknown_key", "/nc"],
    ["an unknown key", job({ ...query, cl, max_tilt: 5 }), 400, "unknown_key", "/max_tilt"],
    ["a candidate that is a number", job({ ...query, cl, candidates: [5] }), 400, "wrong_type", "/candidates/0"],
    ["a step and a list", job({ ...query, cl, step_deg: 5, allowed_deg: { theta_z_deg: [0] } }), 400,
      "conflicting_keys", "/allowed_deg/theta_z_deg"],
    ["a reversed range", job({ ...query, cl, forbidden_deg: [{ theta_x_deg: [9, 1] }] }), 400, "out_of_domain",
      "/forbidden_deg/0/theta_x_deg"],
    ["bounds that are no box", job({ ...query, cl, origin_bounds_mm: { min: [0, 0, 1], max: [0, 0, 0] } }), 400,
      "out_of_domain", "/origin_bounds_mm"],
    ["a damaged CL file", text(query, "GOTO/0,0,x\n"), 400, "damaged_motion", undefined],
  ];
  for (const [title, wanted, status, code, pointer] of refusals) {
    await check(`POST /reorient ${status} ${code}: ${title}`, async () => {
      const { json } = await held(port, { ...wanted, path: "/reorient" }, status);
      assert.deepEqual([json.code, json.pointer], [code, pointer]);
    });
  }
  const words = { origin_bounds_mm: 5, candidates: 5, map: 5, step_deg: "5" };
  for (const [key, value] of Object.entries(words)) {
    await check(`POST /reorient 400 wrong_type: ${key}`, async () => {
      const { json } = await held(port, job({ ...query, cl, [key]: value }, { path: "/reorient" }), 400);
      assert.deepEqual([json.code, json.pointer], ["wrong_type", `/${key}`]);
    });
  }
  const paper = { ...query, cl: fs.readFileSync(path.join(root, "tests/data/papers/cripps-2017-original.cl"), "utf8") };
  const reoriented = async (more) => (await held(port, job({ ...paper, ...more }, { path: "/reorient" }), 200)).json;
  // Cripps et al. 2017, section 3.3: 18.2 rpm where the part is turned by 10 degrees.
  await check("POST /reorient: best is no worse than the turn of the paper", async () => {
    const { best, candidates: [chosen] } = await reoriented({ max_tilt_deg: 10, setup_accuracy_deg: 0, map: false,
      candidates: [{ theta_x_deg: -10 }] });
    assert.ok(Math.abs(chosen.peak.deg_s / 6 - 18.2) < 0.05, `${chosen.peak.deg_s} deg/s`);
    assert.ok(best.peak_ratio <= chosen.peak_ratio && best.tilt_deg <= 10, `${best.peak_ratio}`);
  });
  await check("POST /reorient: what it answers as setup is posted unchanged, and proves", async () => {
    const answer = await reoriented({ map: { step_deg: 30 } });
    for (const { setup } of [answer.best, answer.smallest_tilt, answer.baseline]) {
      const { report } = (await held(port, job({ ...paper, setup }), 200)).json;
      assert.equal(report.verification.passed, true);
    }
    const { report } = (await held(port, job({ ...paper, setup: answer.best.setup }), 200)).json;
    assert.deepEqual(report.zones, []);
    assert.ok(Math.abs(report.predicted_time_s - answer.best.predicted_time_s) < 1e-3);
  });
  await check("POST /reorient: the map has a row for each tilt", async () => {
    const { map } = await reoriented({ max_tilt_deg: 20, map: { step_deg: 10 } });
    assert.equal(map.value.length, map.theta_x_deg.length);
    for (const row of map.value) assert.equal(row.length, map.theta_z_deg.length);
  });
}

/// POST /compare: what it refuses as a whole, and what is one machine's row alone.
async function checkCompare(port) {
  const cl = "UNITS/MM\nFEDRAT/MMPM,600\nGOTO/0,0,0,0,0.6,0.8\nGOTO/9,0,0,0,0.8,0.6\n";
  const machines = ["hermle-c600u", "generic-3axis"];
  const refusals = [
    ["a machine", job({ machine: "hermle-c600u", cl }), 400, "conflicting_keys", "/machine"],
    ["a machine in the query", text({ machine: "hermle-c600u" }, cl), 400, "conflicting_keys", "/machine"],
    ["no machine at all", job({ machines: [], cl }), 400, "out_of_domain", "/machines"],
    ["201 machines", job({ machines: Array(201).fill("generic-3axis"), cl }), 400, "out_of_domain", "/machines"],
    ["machines that are no list", job({ machines: "hermle-c600u", cl }), 400, "wrong_type", "/machines"],
    ["a machine that is a number", job({ machines: [...machines, 5], cl }), 400, "wrong_type", "/machines/2"],
    ["an unknown machine", job({ machines: [...machines, "hermle"], cl }), 404, "unknown_machine", "/machines/2"],
    ["an unknown version", job({ machines: ["generic-3axis@9.9.9"], cl }), 404, "unknown_version", "/machines/0"],
    ["an unknown machine in the query", text({ machines: "generic-3axis,hermle" }, cl), 404, "unknown_machine",
      "/machines/1"],
    ["no name after a comma", text({ machines: "generic-3axis," }, cl), 404, "unknown_machine", "/machines/1"],
    ["a definition that is none", job({ machines: [...machines, { name: "x" }], cl }), 422, "definition_schema",
      "/machines/2"],
    ["two faults: the first", text({ machines: "a,b", reorient: "maybe" }, cl), 404, "unknown_machine", "/machines/0"],
    ["a damaged CL file", job({ machines, cl: "GOTO/0,0,x\n" }), 400, "damaged_motion", undefined],
    ["no motion", text({ machines: machines.join(",") }, "FINI\n"), 400, "no_motion", undefined],
    ["no path", job({ machines }), 400, "missing_key", "/cl"],
    ["an NC program", job({ machines, nc: "%" }), 400, "unknown_key", "/nc"],
    ["a tolerance of 0", job({ machines, cl, tolerances: { tip_mm: 0 } }), 400, "out_of_domain", "/tolerances/tip_mm"],
    ["a share of 0", text({ zone_share: "0" }, cl), 400, "out_of_domain", "/zone_share"],
    ["a word of /reorient", text({ objective: "time" }, cl), 400, "unknown_key", "/objective"],
    ["a word that is no truth", text({ reorient: "maybe" }, cl), 400, "out_of_domain", "/reorient"],
    ["a negative tilt", job({ machines, cl, reorient: { max_tilt_deg: -1 } }), 400, "out_of_domain",
      "/reorient/max_tilt_deg"],
    ["an unknown bound", job({ machines, cl, reorient: { tilt: 0 } }), 400, "unknown_key", "/reorient/tilt"],
    ["a limit of an axis of no machine", job({ machines, cl, limits: { W: { max_speed_mm_s: 1 } } }), 400,
      "out_of_domain", "/limits/W"],
    ["an unknown dialect", job({ machines, cl, post: { dialect: "x" } }), 422, "unknown_dialect", "/post/dialect"],
    ["text for an answer", text({}, cl, { accept: "text/plain" }), 406, "not_acceptable", undefined],
    ["another content type", text({}, cl, { "content-type": "application/xml" }), 415, "unsupported_media_type",
      undefined],
  ];
  for (const [title, wanted, status, code, pointer] of refusals) {
    await check(`POST /compare ${status} ${code}: ${title}`, async () => {
      const { json } = await held(port, { ...wanted, path: "/compare" }, status);
      assert.deepEqual([json.code, json.pointer], [code, pointer]);
    });
  }
  const compared = async (more) => (await held(port, job({ cl, ...more }, { path: "/compare" }), 200)).json;
  await check("POST /compare: all machines where none are named", async () => {
    const names = (await held(port, { path: "/machines" }, 200)).json.machines.map(({ name }) => name);
    const answer = await compared({});
    assert.deepEqual(answer.machines.map(({ name }) => name).sort(), names);
    assert.deepEqual((await held(port, { ...text({}, cl), path: "/compare" }, 200)).json, answer);
  });
  await check("POST /compare: the figures of a row are those of POST /analyse", async () => {
    const paper = fs.readFileSync(path.join(root, "tests/data/papers/cripps-2017-original.cl"), "utf8");
    for (const row of (await compared({ cl: paper })).machines.filter(({ possible }) => possible)) {
      const alone = (await held(port, job({ machine: row.name, cl: paper }, { path: "/analyse" }), 200)).json;
      const { summary } = alone;
      assert.equal(row.sha256, alone.machine.sha256);
      for (const key of ["predicted_time_s", "programmed_time_s", "repositioning_time_s"])
        assert.equal(row[key], summary[key], `${row.name} ${key}`);
      assert.equal(row.peak_ratio, summary.peak_ratio ?? null);
      assert.equal(row.closest_approach_deg, summary.closest_approach_deg ?? null);
      assert.deepEqual([row.zones, row.over_demands], [alone.zones_total, alone.over_demands_total]);
      if (row.peak) assert.equal(row.peak.deg_s ?? row.peak.mm_s,
        alone.axes[row.peak.axis].peak_deg_s ?? alone.axes[row.peak.axis].peak_mm_s);
    }
  });
  await check("POST /compare: one machine's failure leaves the other rows alone", async () => {
    const broken = (await held(port, { path: "/machines/mazak-variaxis-630" }, 200)).json;
    broken.controller.options = { decimals_mm: "three" };
    const rows = (await compared({ machines: [...machines, broken] })).machines;
    const [alone] = (await compared({ machines: ["hermle-c600u"] })).machines;
    assert.deepEqual(rows.map(({ name, possible }) => [name, possible]),
      [["hermle-c600u", true], ["generic-3axis", false], ["mazak-variaxis-630", false]]);
    assert.deepEqual(rows[0], alone);
    assert.deepEqual([rows[1].problem.code, rows[1].problem.cl_line], ["out_of_reach", 3]);
    assert.deepEqual([rows[2].problem.code, rows[2].problem.pointer],
      ["bad_option", "/machines/2/controller/options/decimals_mm"]);
  });
  await check("POST /compare: the three forms are answered alike", async () => {
    const answer = await compared({ machines });
    const plain = { ...text({ machines: machines.join(", ") }, cl), path: "/compare" };
    assert.deepEqual((await held(port, plain, 200)).json, answer);
    const part = (name, content) => `--b\r\nContent-Disposition: form-data; name="${name}"\r\n\r\n${content}\r\n`;
    const form = { method: "POST", path: "/compare", headers: { "content-type": "multipart/form-data; boundary=b" },
      body: `${part("machines", machines.join(","))}${part("cl", cl)}--b--\r\n` };
    assert.deepEqual((await held(port, form, 200)).json, answer);
  });
  await check("POST /compare: the best setup of a machine is that of POST /reorient", async () => {
    const bounds = { max_tilt_deg: 10, setup_accuracy_deg: 0.1 };
    const answer = await compared({ machines, reorient: bounds });
    assert.equal(answer.objective, "peak_ratio");
    const alone = (await held(port, job({ machine: machines[0], cl, ...bounds, map: false }, { path: "/reorient" }), 200)).json;
    assert.deepEqual(answer.machines[0].reorientation,
      { best: alone.best, optimality_gap: alone.optimality_gap, obstacle: alone.obstacle });
  });
  await check("POST /post 400: machines", async () => {
    const { json } = await held(port, text({ machines: "generic-3axis" }, cl), 400);
    assert.deepEqual([json.code, json.pointer], ["unknown_key", "/machines"]);
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
    ["another path", { path: "/interpolate" }, 404, "not_found"],
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
  const ofReorientation = [
    {}, ...["peak_ratio", "time", "rotary_travel", "speed", 1].map((objective) => ({ objective })),
    ...[0, 1, 180, 180.1, "1"].map((max_tilt_deg) => ({ max_tilt_deg })),
    ...[-1, 0, 5, 5.1].map((setup_accuracy_deg) => ({ setup_accuracy_deg })),
    ...[0, 0.001, 360, 361, {}, { theta_x_deg: 5 }, { theta_z_deg: 0 }, { theta: 5 }, "5"].map((step_deg) => ({ step_deg })),
    ...[{}, { theta_x_deg: [0, -360] }, { theta_x_deg: [] }, { theta_z_deg: [361] }, { theta_z_deg: 0 }, [0]]
      .map((allowed_deg) => ({ allowed_deg })),
    { step_deg: 5, allowed_deg: {} }, { step_deg: 5, allowed_deg: { theta_x_deg: [0] } },
    { step_deg: { theta_x_deg: 5 }, allowed_deg: { theta_x_deg: [0] } },
    { step_deg: { theta_z_deg: 5 }, allowed_deg: { theta_z_deg: [0] } },
    { step_deg: { theta_x_deg: 5 }, allowed_deg: { theta_z_deg: [0] } },
    ...[[], [{}], [{ theta_x_deg: [1, 1] }], [{ theta_z_deg: [0, 1, 2] }], [{ theta_x_deg: [-361, 0] }], {}]
      .map((forbidden_deg) => ({ forbidden_deg })),
    ...[{ min: [0, 0, 0], max: [0, 0, 1] }, { min: [0, 0, 0] }, { min: [0, 0], max: [0, 0, 1] },
      { min: [0, 0, 0], max: [0, 0, 2e6] }, []].map((origin_bounds_mm) => ({ origin_bounds_mm })),
    ...[[], [{}], [{ theta_x_deg: 360 }], [{ theta_z_deg: -361 }], [{ tilt_deg: 1 }], [[0, 0]], {}]
      .map((candidates) => ({ candidates })),
    ...[true, false, {}, { step_deg: 45 }, { step_deg: 0.2 }, { step_deg: 46 }, { steps: 1 }, 2].map((map) => ({ map })),
    { zone_share: 1 }, { samples: true }, { nc: "%" }, { max_tilt: 1 }, { cl_units: "mm" }, { cl: "" },
  ];
  const ofComparison = [
    {}, { machines: undefined }, { machines: [] }, { machines: ["generic-3axis", "generic-3axis"] }, { machines: [5] },
    { machines: "generic-3axis" }, { machine: "generic-3axis" }, { zone_share: 0 }, { zone_share: 0.5 },
    { reorient: false }, { reorient: "true" }, { reorient: 1 }, { reorient: { candidates: [] } }, { reorient: { map: true } },
    { reorient: { objective: "speed" } }, { reorient: { max_tilt_deg: 0 } }, { samples: true }, { nc: "%" }, { cl: "" },
    { cl_units: "mm" }, { post: { output: "axes" } }, { limits: { X: { max_speed_mm_s: 10 } } },
  ].map((variant) => ["/compare", { machine: undefined, machines: ["generic-3axis"], ...variant }]);
  const all = [...ofComparison, ...variants.map((variant) => ["/post", variant]),
    ...["/post", "/analyse"].flatMap((place) => ofAnalysis.map((variant) => [place, variant])),
    ...ofReorientation.map((variant) => ["/reorient", { map: false, ...variant }])];
  for (const [place, variant] of all) {
    const body = { ...base, ...variant };
    await check(`${place}: the schema and the server agree on ${JSON.stringify(variant).slice(0, 60)}`, async () => {
      const answer = await held(port, job(body, { path: place }));
      assert.equal(answer.status !== 400, contract.isJob(JSON.parse(JSON.stringify(body)), place), answer.text.slice(0, 300));
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

/// The README's table of all machines.
async function checkCompared(port) {
  await check("the table of machines in the README", async () => {
    const cl = fs.readFileSync(path.join(root, "tests/data/papers/cripps-2017-original.cl"), "utf8");
    const { machines } = (await held(port, { ...text({}, cl), path: "/compare" }, 200)).json;
    const limited = machines.filter(({ peak }) => peak).map((row) => [row.name, row.limits_known,
      row.predicted_time_s.toFixed(2), row.peak_ratio.toFixed(2), row.peak.axis, row.zones, row.over_demands]);
    assert.deepEqual(comparedRows(root), limited);
    const others = machines.slice(limited.length);
    assert.deepEqual(others.map(({ limits_known: known }) => known), [...Array(9).fill("none"), undefined, undefined]);
    assert.deepEqual(others.slice(9).map(({ name }) => name), ["generic-3axis", "generic-4axis-a"]);
  });
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

/// The README's table of real files clamped anew, where those files are.
async function checkRealSetups(port) {
  const folder = path.join(root, "../shared/data/cl");
  if (!fs.existsSync(folder)) return console.log("skipped the README's real setups: their files are not here");
  const rows = reorientedRows(root);
  await check("the table of real setups in the README has its rows", () => assert.equal(rows.length, 5));
  for (const { file, machine, tilt, refusal, before, after } of rows) {
    await check(`the row of ${file} on ${machine} in the README`, async () => {
      const cl = fs.readFileSync(path.join(folder, file), "utf8");
      const units = file.endsWith(".aptsource") ? { cl_units: "inch" } : {};
      const wanted = job({ machine, cl, max_tilt_deg: tilt, map: false, ...units }, { path: "/reorient" });
      const { baseline, best } = (await held(port, wanted, 200)).json;
      const figures = (setup) => [setup.closest_approach_deg, setup.nominal_peak_ratio, setup.predicted_time_s];
      const near = (shown, real) => shown.forEach((value, i) =>
        assert.ok(Math.abs(value - real[i]) <= (i === 1 ? 6e-5 : 6e-3), `${shown}: ${real}`));
      assert.equal(baseline.obstacle?.code, refusal);
      if (before) near(before, figures(baseline));
      near(after, [...figures(best), best.theta_x_deg, best.theta_z_deg]);
    });
  }
}

const server = await start(binary, ["--body-limit-mib", "1", "--threads", "1", "--queue", "0"], root);
try {
  await checkReading(server.port);
  await checkRefusals(server.port);
  await checkPlaces(server.port);
  await checkAnalyse(server.port);
  await checkReorient(server.port);
  await checkCompare(server.port);
  await checkJobSchema(server.port);
  await checkExamples(server.port);
  await checkReadme(server.port);
  await checkCompared(server.port);
  await checkRealFile(server.port);
  await checkRealSetups(server.port);
} finally {
  const code = await server.stop();
  await check("SIGTERM ends the server with 0", () => assert.equal(code, 0));
}
await check("every operation of the document was called", () => assert.deepEqual(contract.uncalled(), []));
process.exitCode = failures === 0 ? 0 : 1;
