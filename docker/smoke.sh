#!/usr/bin/env bash
# Builds the image, starts it locked down, posts a CL file as the README does and stops it again.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

fail() {
  printf 'error: %s\n' "$*" >&2
  exit 1
}

engine="${ENGINE:-$(command -v docker || command -v podman || true)}"
[ -n "$engine" ] || fail "neither docker nor podman is here; ENGINE names another"
image="${IMAGE:-pentapost}"
port="${PORT:-18080}"
name="pentapost-smoke-$$"
read -r -a build_options <<<"${BUILD_OPTIONS:-}"
read -r -a run_options <<<"${RUN_OPTIONS:-}"

"$engine" build "${build_options[@]}" -f docker/Dockerfile -t "$image" .
trap '"$engine" rm -f "$name" >/dev/null 2>&1 || true' EXIT
"$engine" run "${run_options[@]}" --detach --name "$name" --read-only --cap-drop ALL \
  --security-opt no-new-privileges --memory 1g --pids-limit 256 \
  --publish "127.0.0.1:$port:8080" "$image" >/dev/null

for _ in $(seq 100); do
  curl --silent --fail "http://127.0.0.1:$port/healthz" >/dev/null && break
  sleep 0.1
done
curl --silent --fail "http://127.0.0.1:$port/healthz" >/dev/null || {
  "$engine" logs "$name" >&2
  fail "the container does not answer on port $port"
}
nc="$(curl --silent --fail-with-body -H 'Content-Type: text/plain' \
  --data-binary @tests/data/papers/cripps-2017-original.cl \
  "http://127.0.0.1:$port/post?machine=hermle-c600u&axis_deg=0.1")"
grep -q 'X+14 Y+0 Z-8 A+7.141 C+117.071' <<<"$nc" || fail "the NC program is not the one of the paper"
[ "$("$engine" exec "$name" id -u)" != 0 ] || fail "the server runs as root"
"$engine" stop --time 30 "$name" >/dev/null
code="$("$engine" inspect --format '{{.State.ExitCode}}' "$name")"
[ "$code" = 0 ] || fail "SIGTERM ended the server with exit code $code"
echo "smoke test passed: $(wc -l <<<"$nc") lines of NC"
