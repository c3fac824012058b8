# Sourced by wasm.sh and aarch64.sh: builds the corpus for this machine and for another, and compares what they print.
#
# The native program is built as the tests are, whole workspace and all: built alone, its dependencies would have other
# features, and everything would be compiled a second time.
# shellcheck shell=bash

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
TARGET_DIR=${CARGO_TARGET_DIR:-target}
HASHES=$(mktemp -d)
trap 'rm -rf "$HASHES"' EXIT

native_hashes() { # Writes the list that the others are compared with.
    cargo test --quiet --workspace --no-run
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

both() { # Runs the function $1 for $2 and for $3, at the same time; fails if either does.
    "$1" "$2" &
    local first=$! status=0
    "$1" "$3" || status=$?
    wait "$first" || status=$?
    return "$status"
}
