//! Help, version, completions and manual pages: all there, and readable on a terminal of 80 columns.

use crate::support::Folder;

fn help(arguments: &str) -> String {
    Folder::new().run(arguments).succeeds_quietly().text().to_owned()
}

#[test]
fn help_fits_80_columns_and_begins_with_examples() {
    for arguments in [
        "--help",
        "-h",
        "render --help",
        "render -h",
        "turntable --help",
        "turntable -h",
        "compare --help",
        "compare -h",
        "explain --help",
        "explain -h",
        "completions --help",
        "man --help",
    ] {
        let text = help(arguments);
        for line in text.lines() {
            assert!(line.chars().count() < 80, "{arguments}: {line}");
        }
        let (examples, usage) = (text.find("Examples:").unwrap(), text.find("Usage:").unwrap());
        assert!(examples < usage, "{arguments}");
    }
    assert!(help("-h").len() < help("--help").len());
    assert!(help("render -h").len() < help("render --help").len());
}

#[test]
fn exit_codes_and_choices_are_documented() {
    assert!(help("--help").contains("Exit codes:"));
    let render = help("render --help");
    for word in ["blinn-phong", "overdraw", "--anisotropy", "point:X,Y,Z", "Exit codes", "[default: 1024x768]"] {
        assert!(render.contains(word), "{word}");
    }
    assert!(help("turntable --help").contains("[default: 512x512]"));
    assert_eq!(help("--version"), concat!("trigon ", env!("CARGO_PKG_VERSION"), "\n"));
}

#[test]
fn nothing_at_all_shows_the_help_as_a_usage_error() {
    let finished = Folder::new().run("");
    assert_eq!(finished.code, Some(2));
    assert!(finished.stderr.contains("Examples:"), "{}", finished.stderr);
}

#[test]
fn completions_and_manual_pages_know_the_options() {
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let script = help(&format!("completions {shell}"));
        for word in ["turntable", "anisotropy"] {
            assert!(script.contains(word), "{shell}: {word}");
        }
        let knows_values = ["bash", "fish", "zsh"].contains(&shell);
        assert_eq!(script.contains("blinn-phong"), knows_values, "{shell}");
    }
    assert!(help("man").contains(".TH trigon 1"));
    let page = help("man render");
    assert!(page.contains(".TH trigon-render 1"), "{page}");
    assert!(page.contains("anisotropy") && page.contains(".SH EXAMPLES") && page.contains("Exit codes"));
    Folder::new().run("man rendr").misuses_with(&["did you mean render?"]);
    Folder::new().run("completions tcsh").misuses_with(&["tcsh", "zsh"]);
}
