#!/usr/bin/env bash
# The lines of screenshot-glb that are above each, with telar.
set -euo pipefail

# screenshot-glb -i shirt.glb -o plain.png -w 600 -h 800
npx telar thumbnail shirt.glb -o plain.png --size 600x800

# screenshot-glb -i shirt.glb -o white.jpg -w 512 -h 512 -c white -f image/jpeg -q 0.9
npx telar thumbnail shirt.glb -o white.jpg --size 512 --background white --set output.quality=90

# screenshot-glb -i shirt.glb -o bright.png -w 512 -h 512 -t 20000 -m "exposure=1.5"
npx telar thumbnail shirt.glb -o bright.png --size 512 --timeout-ms 20000 --set exposure=1.5

# screenshot-glb -i shirt.glb -o turned.png -w 512 -h 512 -m "camera-orbit=30deg 75deg auto"
npx telar thumbnail shirt.glb -o turned.png --size 512 --set camera.azimuth=30 --set camera.elevation=15
