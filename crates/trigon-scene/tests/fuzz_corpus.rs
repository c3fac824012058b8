//! The saved fuzz corpus, replayed without a fuzzer: every file that was ever of interest still loads or fails cleanly.

#[path = "../../../fuzz/checks.rs"]
mod checks;

use std::path::Path;

fn replay(target: &str, check: fn(&[u8])) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/corpus").join(target);
    let mut n_files = 0;
    for entry in std::fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display())) {
        let bytes = std::fs::read(entry.unwrap().path()).unwrap();
        check(&bytes);
        // Files cut short and with a flipped bit are the next neighbours.
        for len in (0..bytes.len()).step_by(bytes.len() / 64 + 1) {
            check(&bytes[..len]);
            let mut flipped = bytes.clone();
            flipped[len] ^= 1 << (len % 8);
            check(&flipped);
        }
        n_files += 1;
    }
    assert!(n_files >= 5, "only {n_files} files in {}", folder.display());
}

#[test]
fn obj_corpus_is_survived() {
    replay("obj", checks::obj);
}

#[test]
fn mtl_corpus_is_survived() {
    replay("mtl", checks::mtl);
}

#[test]
fn tga_corpus_is_survived() {
    replay("tga", checks::tga);
}

#[test]
fn jpeg_corpus_is_survived() {
    replay("jpeg", checks::jpeg);
}
