#!/usr/bin/env bash
# Whether the client shows what the server draws: screenshots/NAME.png, which say their shot, against models/NAME.glb. A page with the figures of
# each goes to report/NAME. Exit code 1: a picture is over the gate.
set -uo pipefail
worst=0
for screenshot in screenshots/*.png; do
  name=$(basename "$screenshot" .png)
  npx telar compare "$screenshot" --model "models/$name.glb" --gate "${GATE:-other-gl}" --report "report/$name" --explain
  code=$?
  if ((code > worst)); then worst=$code; fi
done
exit "$worst"
