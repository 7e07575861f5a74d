ZEDIT="$2" TELAR_BUILD_DIR=/tmp/ed/out/release timeout 200 node test/parity/run.mjs --random 1 --seed $1 2>&1 | grep random- | cut -c1-110
for w in browser telar; do cp out/parity/pictures/random-three-$1.$w.png /tmp/z-$3-$w.png; done
