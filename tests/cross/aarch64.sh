#!/usr/bin/env bash
# The frame hashes of the corpus on 64-bit ARM, with NEON and with scalar code, equal those of this machine. Emulated,
# where this machine is another.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/compare.sh"

TARGET=aarch64-unknown-linux-gnu
export CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_LINKER=aarch64-linux-gnu-gcc
EMULATOR=(qemu-aarch64 -L /usr/aarch64-linux-gnu)

run_program() { # $1 is the SIMD level.
    TRIGON_SIMD=$1 "${EMULATOR[@]}" "$TARGET_DIR/$TARGET/debug/frame-hashes" >"$HASHES/$1"
}

native_hashes
cargo build --profile test --package trigon-tests --bin frame-hashes --target "$TARGET"
both run_program neon scalar
compare_hashes neon
compare_hashes scalar
