// Exit codes and outputs of the commands.
//   node command_line.mjs PENTAPOST
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { fileURLToPath } from "node:url";
import test from "node:test";

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "../..");
const binary = path.resolve(process.argv[2]);
const folder = fs.mkdtempSync(path.join(os.tmpdir(), "pentapost-"));
process.on("exit", () => fs.rmSync(folder, { recursive: true }));

function run(...words) {
  const { input, env } = typeof words.at(-1) === "object" ? words.pop() : {};
  const result = spawnSync(binary, words, { input, encoding: "utf8", cwd: folder,
    env: { ...process.env, PENTAPOST_MACHINES: path.join(root, "machines"), ...env } });
  return { code: result.status, out: result.stdout, err: result.stderr };
}

function file(name, text) {
  fs.writeFileSync(path.join(folder, name), text);
  return name;
}

const good = file("good.cls", "UNITS/MM\nFEDRAT/MMPM,600\nGOTO/0,0,0,0,0,1\nGOTO/10,0,0,0,0,1\nFINI\n");
const damaged = file("damaged.cls", "UNITS/MM\nFEDRAT/MMPM,600\nGOTO/0,0,x\n");
const empty = file("empty.json", "{}");
fs.linkSync(path.join(folder, good), path.join(folder, "hard.cls"));
fs.symlinkSync(good, path.join(folder, "soft.cls"));
const definition = JSON.parse(fs.readFileSync(path.join(root, "machines/generic-3axis/1.0.0.json"), "utf8"));
definition.controller.options = { tcp_on: ["G43.4 H{foo}"] };
fs.mkdirSync(path.join(folder, "machines/generic-3axis"), { recursive: true });
file("machines/generic-3axis/1.0.0.json", JSON.stringify(definition));
const below = file("below.cls", "UNITS/MM\nFEDRAT/MMPM,600\nGOTO/0,0,0,0,0,1\nGOTO/10,0,0,0.6,0,0.8\n");

test("post writes the program to stdout and the report to stderr", () => {
  const { code, out, err } = run("post", good, "--machine", "generic-3axis");
  assert.equal(code, 0, err);
  assert.match(out, /M30/);
  assert.equal(JSON.parse(err).verification.passed, true);
});

test("post reads stdin, and writes files where told to", () => {
  const input = fs.readFileSync(path.join(folder, good), "utf8");
  const { code, out, err } = run("post", "-", "--machine", "generic-3axis", "--out", "a.nc", "--report", "a.json",
    { input });
  assert.deepEqual([code, out, err], [0, "", ""]);
  assert.match(fs.readFileSync(path.join(folder, "a.nc"), "utf8"), /M30/);
  assert.equal(JSON.parse(fs.readFileSync(path.join(folder, "a.json"), "utf8")).machine.name, "generic-3axis");
});

test("post takes a job and the machine from the environment", () => {
  const job = file("job.json", '{"tolerances": {"tip_mm": 0.02}}');
  assert.equal(run("post", good, "--job", job, { env: { PENTAPOST_MACHINE: "generic-3axis" } }).code, 0);
});

test("analyse reads an NC program", () => {
  const program = path.join(root, "tests/data/papers/cripps-2017-appendix-1.nc");
  const { code, out } = run("analyse", program, "--nc", "--nc-dialect", "heidenhain-iso", "--machine", "hermle-c600u");
  assert.equal(code, 0);
  assert.equal(JSON.parse(out).nc.lines, 77);
});

test("analyse writes the analysis to stdout", () => {
  const { code, out, err } = run("analyse", good, "--machine", "hermle-c600u", "--zone-share", "0.5");
  assert.deepEqual([code, err], [0, ""]);
  const { summary, zones } = JSON.parse(out);
  assert.equal(summary.length_mm, 10);
  assert.deepEqual(zones, []);
});

test("reorient writes the setups to stdout, the same bytes every time", () => {
  const words = ["reorient", path.join(root, "tests/data/papers/cripps-2017-original.cl"), "--machine", "hermle-c600u",
    "--objective", "time", "--max-tilt-deg", "10", "--setup-accuracy-deg", "0.1"];
  const { code, out, err } = run(...words);
  assert.deepEqual([code, err], [0, ""]);
  const { objective, best } = JSON.parse(out);
  assert.equal(objective, "time");
  assert.ok(best.tilt_deg <= 10);
  assert.equal(out, run(...words).out);
});

test("compare writes the machines to stdout, all or those named", () => {
  const { code, out, err } = run("compare", good);
  assert.deepEqual([code, err], [0, ""]);
  assert.equal(JSON.parse(out).machines.length, fs.readdirSync(path.join(root, "machines"), { withFileTypes: true })
    .filter((entry) => entry.isDirectory()).length);
  const two = run("compare", good, "--machine", "generic-3axis,hermle-c600u@1.0.0");
  assert.deepEqual(JSON.parse(two.out).machines.map(({ name }) => name).sort(), ["generic-3axis", "hermle-c600u"]);
  assert.equal(two.out, run("compare", good, "--machine", "generic-3axis", "--machine", "hermle-c600u@1.0.0").out);
});

test("compare answers a path that no machine can follow", () => {
  const { code, out } = run("compare", below, "--machine", "generic-3axis");
  assert.equal(code, 0);
  assert.equal(JSON.parse(out).machines[0].problem.code, "out_of_reach");
});

test("post answers the same bytes every time", () => {
  const first = run("post", good, "--machine", "hermle-c600u");
  assert.equal(first.out, run("post", good, "--machine", "hermle-c600u").out);
});

for (const [title, words, expected, text] of [
  ["no command", [], 1, /subcommand/i],
  ["an unknown option", ["post", good, "--tip", "1"], 1, /--tip/],
  ["an unusable port", ["serve", "--port", "70000"], 1, /70000/],
  ["a damaged CL file", ["post", damaged, "--machine", "generic-3axis"], 2, /"cl_line":3/],
  ["an unknown command", ["foo"], 1, /foo[^]*serve, post, analyse, reorient, compare, machines, dialects, version/],
  ["no machine", ["post", good], 1, /--machine/],
  ["no file", ["post", "--machine", "generic-3axis"], 1, /give FILE or -/],
  ["a job and no path", ["post", "--machine", "generic-3axis", "--job", empty], 2, /missing_key/],
  ["a tolerance that lost its point", ["post", good, "--machine", "generic-3axis", "--tip-mm", "10"], 2, /at most 1/],
  ["one file for program and report", ["post", good, "--machine", "generic-3axis", "--out", "s.nc", "--report", "x/../s.nc"],
    1, /--report and --out are the same file/],
  ["the program into its own CL file", ["post", good, "--machine", "generic-3axis", "--out", `./${good}`], 1,
    /--out and FILE are the same file/],
  ["the report into the CL file by another name", ["post", good, "--machine", "generic-3axis", "--report", "hard.cls"], 1,
    /--report and FILE are the same file/],
  ["the report into the CL file by a link", ["post", good, "--machine", "generic-3axis", "--report", "soft.cls"], 1,
    /--report and FILE are the same file/],
  ["the report into the job's file", ["post", good, "--machine", "generic-3axis", "--job", empty, "--report", empty], 1,
    /--report and --job are the same file/],
  ["a report that can't be written", ["post", good, "--machine", "generic-3axis", "--report", "none/x"], 5, /none\/x/],
  ["a report that can't be written beside a file", ["post", good, "--machine", "generic-3axis", "--out", "p.nc",
    "--report", "none/x"], 5, /none\/x/],
  ["a machine with an unusable option", ["serve", "--check", "--machines", "machines"], 5,
    /options\/tcp_on: option tcp_on: \{foo\}/],
  ["a share of 0", ["analyse", good, "--machine", "generic-3axis", "--zone-share", "0"], 2, /"pointer":"\/zone_share"/],
  ["an analysis without a machine", ["analyse", good], 1, /pentapost analyse: give --machine/],
  ["a negative tilt", ["reorient", good, "--machine", "hermle-c600u", "--max-tilt-deg", "-1"], 2, /"pointer":"\/max_tilt_deg"/],
  ["an unknown objective", ["reorient", good, "--machine", "hermle-c600u", "--objective", "speed"], 2, /peak_ratio, time, rotary_travel/],
  ["a reorientation without a machine", ["reorient", good], 1, /pentapost reorient: give --machine/],
  ["an unknown machine to compare", ["compare", good, "--machine", "generic-3axis,herml"], 2, /"pointer":"\/machines\/1"/],
  ["a comparison without a file", ["compare"], 1, /pentapost compare: give FILE/],
  ["a comparison of a damaged CL file", ["compare", damaged], 2, /"cl_line":3/],
  ["an analysis out of reach", ["analyse", below, "--machine", "generic-3axis"], 3, /out_of_reach/],
  ["an unknown machine", ["post", good, "--machine", "generic-3axs"], 2, /generic-3axis/],
  ["a bad tolerance", ["post", good, "--machine", "generic-3axis", "--tip-mm", "0"], 2, /tolerances\/tip_mm/],
  ["a tool axis out of reach", ["post", below, "--machine", "generic-3axis"], 3, /out_of_reach/],
  ["a file that is not there", ["post", "none.cls", "--machine", "generic-3axis"], 5, /none\.cls/],
  ["a folder for a file", ["post", ".", "--machine", "generic-3axis"], 5, /cannot read \./],
  ["an output that can't be written", ["post", good, "--machine", "generic-3axis", "--out", "none/a.nc"], 5, /none\/a\.nc/],
  ["a folder without machines", ["serve", "--check", "--machines", "none"], 5, /none/],
]) {
  test(`exit code ${expected}: ${title}`, () => {
    const { code, out, err } = run(...words);
    assert.equal(code, expected, err);
    assert.match(err, text);
    assert.equal(out, "");
  });
}

test("exit code 5, with a word: standard output that takes nothing", () => {
  const full = fs.openSync("/dev/full", "w");
  const { status, stderr } = spawnSync(binary, ["post", good, "--machine", "generic-3axis"],
    { stdio: ["ignore", full, "pipe"], encoding: "utf8", cwd: folder,
      env: { ...process.env, PENTAPOST_MACHINES: path.join(root, "machines") } });
  fs.closeSync(full);
  assert.equal(status, 5);
  assert.match(stderr, /standard output/);
});

test("what is refused or not written leaves inputs and outputs as they were", () => {
  assert.match(fs.readFileSync(path.join(folder, good), "utf8"), /^UNITS/);
  assert.equal(fs.readFileSync(path.join(folder, empty), "utf8"), "{}");
  assert.deepEqual(fs.readdirSync(folder).filter((name) => /^[sp]\.nc|part/.test(name)), []);
});

test("program and report can both go to /dev/null", () => {
  assert.equal(run("post", good, "--machine", "generic-3axis", "--out", "/dev/null", "--report", "/dev/null").code, 0);
});

test("a file beside the output keeps its bytes", () => {
  file("k.nc.part", "kept");
  assert.equal(run("post", good, "--machine", "generic-3axis", "--out", "k.nc").code, 0);
  assert.equal(fs.readFileSync(path.join(folder, "k.nc.part"), "utf8"), "kept");
  fs.rmSync(path.join(folder, "k.nc.part"));
});

test("a program without PARTNO has the name of its file, from standard input none", () => {
  const input = fs.readFileSync(path.join(folder, good), "utf8");
  assert.match(run("post", good, "--machine", "hermle-c600u").out, /^%GOOD G71/);
  assert.match(run("post", "-", "--machine", "hermle-c600u", { input }).out, /^%PROGRAM G71/);
  assert.match(run("post", good, "--machine", "hermle-c600u", "--program-name", "OTHER").out, /^%OTHER G71/);
  const named = file("file.cls", `PARTNO/PART\n${input}`);
  assert.match(run("post", named, "--machine", "hermle-c600u").out, /^%PART G71/);
  assert.match(run("post", file("1234.cls", input), "--machine", "generic-3axis").out, /^%\nO1234\n/);
});

test("a refusal leaves no file behind", () => {
  assert.equal(run("post", below, "--machine", "generic-3axis", "--out", "b.nc").code, 3);
  assert.deepEqual(fs.readdirSync(folder).filter((name) => name.startsWith("b.nc")), []);
});

test("a pipe is written to and stays one", () => {
  const script = 'mkfifo pipe && cat pipe & while ! [ -p pipe ]; do sleep 0.01; done; "$@" && wait && [ -p pipe ]';
  const words = ["post", good, "--machine", "generic-3axis", "--machines", path.join(root, "machines"),
    "--out", "pipe", "--report", "pipe.json"];
  const result = spawnSync("sh", ["-c", script, "sh", binary, ...words], { cwd: folder, encoding: "utf8", timeout: 60000 });
  assert.equal(result.status, 0, result.stderr);
  assert.match(result.stdout, /M30/);
});

test("a symbolic link stays one", () => {
  file("linked.nc", "");
  fs.symlinkSync("linked.nc", path.join(folder, "link.nc"));
  assert.equal(run("post", good, "--machine", "generic-3axis", "--out", "link.nc").code, 0);
  assert.equal(fs.readlinkSync(path.join(folder, "link.nc")), "linked.nc");
  assert.match(fs.readFileSync(path.join(folder, "linked.nc"), "utf8"), /M30/);
});

test("the other commands answer", () => {
  assert.match(run("machines").out, /^hermle-c600u@1\.0\.0\t/m);
  assert.match(run("dialects").out, /^fanuc-30i\t/m);
  assert.match(run("version").out, /^pentapost \d+\.\d+\.\d+\n$/);
  assert.match(run("serve", "--check").out, /^\d+ machines in /);
  for (const command of ["serve", "post", "analyse", "reorient", "compare", "machines", "dialects", "version"]) {
    const { code, out } = run(command, "--help");
    assert.equal(code, 0);
    assert.match(out, /Usage: pentapost/);
  }
});
