#!/bin/sh
# The commands of docs/making-a-game.md, in the folder where room.gltf lies and build/ has the programs. style.docs
# compares the page with this file.
set -eu

build/room room.gltf room.png
lanthorn render room.gltf --camera player-eyes --size 320x180 --technique path --set path.unlimited=true --spp 256 -o path.png
lanthorn compare room.png path.png --metric bias --max 0.1

build/use room.gltf
build/puzzle room.gltf .

lanthorn inspect room.gltf --plan
lamplighter --headless --level room.gltf
sed 's/"seconds": 1}/"seconds": 0}/' room.gltf > wrong.gltf
set +e
lamplighter --headless --level wrong.gltf
code=$?
set -e
[ $code = 2 ]

lamplighter --headless --level room.gltf --record room.rec --out pictures --frames 6 --size 320x180
lamplighter --headless --level room.gltf --replay room.rec
lamplighter --headless --level room.gltf --replay room.rec --out replayed --frames 6 --size 64x36
