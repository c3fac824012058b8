#!/usr/bin/env bash
# The frame hashes of the corpus under Node, as WebAssembly without and with simd128, equal those of this machine.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/compare.sh"

TARGET=wasm32-unknown-unknown

build_module() { # $1 names the list, $2 are flags of the compiler. Each has a folder: flags are part of no file name.
    RUSTFLAGS=$2 cargo build --profile test --package trigon-tests --example frame-hashes --target "$TARGET" \
        --target-dir "$TARGET_DIR/$1"
}

run_module() {
    node tests/cross/wasm.mjs "$TARGET_DIR/$1/$TARGET/debug/examples/frame_hashes.wasm" >"$HASHES/$1"
}

native_hashes
build_module wasm ""
build_module wasm-simd128 "-C target-feature=+simd128"
both run_module wasm wasm-simd128
compare_hashes wasm
compare_hashes wasm-simd128
