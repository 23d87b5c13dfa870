// A pentapost server on a free port, and requests to it.
import { spawn } from "node:child_process";
import http from "node:http";
import net from "node:net";
import path from "node:path";
import readline from "node:readline";

/// Starts `pentapost serve` and waits until it listens.
export async function start(binary, options, root) {
  const machines = path.join(root, "machines");
  const child = spawn(binary, ["serve", "--port", "0", "--machines", machines, ...options],
    { stdio: ["ignore", "inherit", "pipe"] });
  const ended = new Promise((resolve) => child.once("exit", (code) => resolve(code)));
  const lines = readline.createInterface({ input: child.stderr });
  const port = await new Promise((resolve, reject) => {
    lines.on("line", (line) => {
      let event = {};
      try {
        event = JSON.parse(line);
      } catch {
        console.error(line);
      }
      if (event.event === "listening") resolve(event.port);
      if (event.event === "defect") console.error(line);
    });
    ended.then((code) => reject(new Error(`the server ended with ${code}`)));
  });
  const stop = async () => {
    child.kill("SIGTERM");
    return ended;
  };
  return { port, stop };
}

/// One request on a connection of its own.
/// @param wanted  {method, path, query, headers, body, chunked}
export function request(port, { method = "GET", path: place, query, headers = {}, body, chunked }) {
  const search = query ? `?${new URLSearchParams(query)}` : "";
  return new Promise((resolve, reject) => {
    let answered = false;
    const sent = http.request({ port, method, path: place + search, agent: false,
      headers: { ...headers, ...(body !== undefined && !chunked && { "content-length": Buffer.byteLength(body) }) } },
    (response) => {
      answered = true;
      const parts = [];
      response.on("data", (part) => parts.push(part));
      response.on("error", reject);
      response.on("end", () => {
        const bytes = Buffer.concat(parts);
        const text = bytes.toString("utf8");
        const isJson = /^application\/([a-z.]+\+)?json/.test(response.headers["content-type"] ?? "");
        const json = isJson && bytes.length > 0 ? JSON.parse(text) : undefined;
        resolve({ status: response.statusCode, headers: response.headers, bytes, text, json });
      });
    });
    // A refused body: the answer may come before all of it is written.
    sent.on("error", (error) => answered || reject(error));
    if (body !== undefined) sent.write(body);
    sent.end();
  });
}

/// A connection on which `text` was sent and an interim answer came.
export function open(port, text) {
  return new Promise((resolve, reject) => {
    const socket = net.connect(port, "127.0.0.1", () => socket.write(text));
    socket.once("data", () => resolve(socket));
    socket.once("error", reject);
  });
}
