#!/usr/bin/env bash
# The frame hashes of the corpus under Node, as WebAssembly without and with simd128, equal those of this machine.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/compare.sh"

TARGET=wasm32-unknown-unknown

wasm_hashes() { # $1 names the list, $2 are flags of the compiler. Each has a folder: flags are part of no file name.
    RUSTFLAGS=$2 cargo build --profile test --package trigon-tests --example frame-hashes --target "$TARGET" \
        --target-dir "$TARGET_DIR/$1"
    node tests/cross/wasm.mjs "$TARGET_DIR/$1/$TARGET/debug/examples/frame_hashes.wasm" >"$HASHES/$1"
    compare_hashes "$1"
}

native_hashes
wasm_hashes wasm ""
wasm_hashes wasm-simd128 "-C target-feature=+simd128"
