//! The saved fuzz corpus, replayed without a fuzzer: every file that was ever of interest still is drawn or refused.

#[path = "../../../fuzz/checks_svg.rs"]
mod checks_svg;

use std::path::Path;

#[test]
fn svg_corpus_is_survived() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/corpus/svg");
    let mut n_files = 0;
    for entry in std::fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display())) {
        let bytes = std::fs::read(entry.unwrap().path()).unwrap();
        checks_svg::svg(&bytes);
        // Files with a changed byte are the next neighbours; most stay well-formed.
        for at in (0..bytes.len()).step_by(bytes.len() / 64 + 1) {
            for replacement in [b'9', b'-', b'#', b' '] {
                let mut changed = bytes.clone();
                changed[at] = replacement;
                checks_svg::svg(&changed);
            }
        }
        n_files += 1;
    }
    assert!(n_files >= 5, "only {n_files} files in {}", folder.display());
}
