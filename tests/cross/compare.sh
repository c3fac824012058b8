# Sourced by wasm.sh and aarch64.sh: builds the corpus for this machine and for another, and compares what they print.
#
# The profile is that of the tests, which have built the native program already when all of .ci/run is run.
# shellcheck shell=bash

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
TARGET_DIR=${CARGO_TARGET_DIR:-target}
HASHES=$(mktemp -d)
trap 'rm -rf "$HASHES"' EXIT

native_hashes() { # Writes the list that the others are compared with.
    cargo build --profile test --package trigon-tests --bin frame-hashes
    "$TARGET_DIR/debug/frame-hashes" >"$HASHES/native"
    [[ -s $HASHES/native ]] || { echo "FAILED: no frame was drawn"; exit 1; }
}

compare_hashes() { # $1 names the list that was made, $HASHES/$1.
    if ! diff --unified=0 "$HASHES/native" "$HASHES/$1" >"$HASHES/difference"; then
        echo "FAILED: $1 differs from this machine (-) in:"
        cat "$HASHES/difference"
        exit 1
    fi
    echo "$1: all $(wc -l <"$HASHES/$1") hashes are those of this machine"
}
