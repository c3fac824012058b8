//! Code that is generic over the lanes: no closures, no fused multiply-add.
//!
//! A kernel is compiled once per SIMD level by inlining all of it into one function that has the CPU's features. A
//! closure is a function of its own: where it is not inlined it is compiled without them, and each vector operation
//! in it becomes a call. Found with tokens: a closure in a function, or in an `impl` or `trait`, whose header names
//! `Lanes` or `Simd`.

use std::ops::Range;

use super::finding::{Finding, Rule};
use super::tokens::{Kind, Scan, scan};
use super::tree::Tree;

static CLOSURE: Rule = Rule {
    name: "lane-closure",
    why: "a closure that is not inlined is compiled without the CPU's features: measured 4 to 12 times slower",
    fix: "use an operator, a method or a loop; mark the closure `#[inline(always)]`; or, where no lanes are in it, \
          excuse it with `// tidy: allow(lane-closure): reason`",
    excusable: true,
};

static FUSED: Rule = Rule {
    name: "fused",
    why: "a fused multiply-add rounds once, a product and a sum twice: pictures would differ between CPUs",
    fix: "write the product and the sum",
    excusable: false,
};

/// Names that make a header generic over the lanes.
const LANE_BOUNDS: [&str; 2] = ["Lanes", "Simd"];
const FUSED_METHODS: [&str; 8] =
    ["mul_add", "mul_sub", "neg_mul_add", "neg_mul_sub", "fma", "fmaf", "relaxed_mul_add", "madd"];

/// Closures in lane code.
pub(crate) fn closures(tree: &Tree) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (path, text) in tree.rust().filter(|(path, _)| path.starts_with("crates/")) {
        let scan = scan(text);
        let tests = scan.test_modules();
        let bodies = lane_bodies(&scan);
        for index in 0..scan.tokens.len() {
            let within = |ranges: &[Range<usize>]| ranges.iter().any(|range| range.contains(&index));
            if is_closure(&scan, index) && within(&bodies) && !within(&tests) {
                findings.push(Finding::new(&CLOSURE, path, scan.tokens[index].line, "closure in lane code"));
            }
        }
    }
    findings
}

/// Fused multiply-adds anywhere in the crates.
pub(crate) fn fused(tree: &Tree) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (path, text) in tree.rust().filter(|(path, _)| path.starts_with("crates/")) {
        let scan = scan(text);
        for (index, token) in scan.tokens.iter().enumerate() {
            let is_called = index > 0 && matches!(scan.text(index - 1), "." | "::") && scan.text(index + 1) == "(";
            if is_called && FUSED_METHODS.contains(&token.text) {
                findings.push(Finding::new(&FUSED, path, token.line, format!("`{}`", token.text)));
            }
        }
    }
    findings
}

/// The bodies of all functions, impls and traits whose header names a lane bound.
fn lane_bodies(scan: &Scan<'_>) -> Vec<Range<usize>> {
    let mut bodies = Vec::new();
    for (start, token) in scan.tokens.iter().enumerate() {
        let is_item = token.kind == Kind::Ident && matches!(token.text, "fn" | "impl" | "trait");
        // `fn` and `impl` inside a header are types; those headers are covered by the item they are in.
        if !is_item || !begins_item(scan, start) {
            continue;
        }
        let Some(open) = body_of(scan, start) else { continue };
        let header = &scan.tokens[start..open];
        if header.iter().any(|token| LANE_BOUNDS.contains(&token.text)) {
            bodies.push(open..scan.closing(open));
        }
    }
    bodies
}

fn begins_item(scan: &Scan<'_>, start: usize) -> bool {
    let named = scan.tokens.get(start + 1).is_some_and(|next| next.kind == Kind::Ident || next.text == "<");
    let before = if start == 0 { "" } else { scan.text(start - 1) };
    named && !matches!(before, "(" | "," | ":" | "->" | "<" | "=" | "+" | "&")
}

/// The `{` of the body of the item at `start`; `None` if the item ends with `;`.
fn body_of(scan: &Scan<'_>, start: usize) -> Option<usize> {
    let mut at = start;
    while at < scan.tokens.len() {
        match scan.text(at) {
            "{" => return Some(at),
            ";" => return None,
            "(" | "[" => at = scan.closing(at) + 1,
            _ => at += 1,
        }
    }
    None
}

/// Whether the token at `index` opens the parameters of a closure that is not marked `#[inline(always)]`.
fn is_closure(scan: &Scan<'_>, index: usize) -> bool {
    if !matches!(scan.text(index), "|" | "||") || index == 0 {
        return false;
    }
    let before = if scan.text(index - 1) == "move" { index.saturating_sub(2) } else { index - 1 };
    match scan.text(before) {
        "(" | "," | "=" | "{" | ";" | ":" | "=>" | "return" | "&" | "&&" | "!" | "else" | "in" => {
            // A leading `|` of a pattern is followed by `=>`, `if` or another `|` outside brackets, not by a body.
            !is_leading_or_pattern(scan, index)
        }
        // After an attribute: `#[inline(always)] |x| ..`.
        "]" => {
            !scan.is_at(before.saturating_sub(6), &["#", "[", "inline", "(", "always", ")", "]"])
                && is_attribute(scan, before)
        }
        _ => false,
    }
}

fn is_attribute(scan: &Scan<'_>, close: usize) -> bool {
    (0..close).rev().take(16).any(|open| scan.is_at(open, &["#", "["]) && scan.closing(open + 1) == close)
}

fn is_leading_or_pattern(scan: &Scan<'_>, index: usize) -> bool {
    let after_arm = matches!(scan.text(index.wrapping_sub(1)), "{" | ",");
    if scan.text(index) != "|" || !after_arm {
        return false;
    }
    let mut at = index + 1;
    while at < scan.tokens.len() {
        match scan.text(at) {
            "=>" => return true,
            "(" | "[" | "{" => at = scan.closing(at) + 1,
            ")" | "]" | "}" | ";" | "," => return false,
            _ => at += 1,
        }
    }
    false
}

#[cfg(test)]
mod tests {
    use super::*;

    fn closure_lines(text: &str) -> Vec<usize> {
        closures(&Tree::of(&[("crates/trigon/src/shade/a.rs", text)])).iter().map(|finding| finding.line).collect()
    }

    #[test]
    fn closures_in_lane_functions_are_found() {
        assert_eq!(closure_lines("fn f<L: Lanes>(l: L) {\n    a.map(|x| x + l);\n}\n"), [2]);
        assert_eq!(closure_lines("fn f(l: impl Lanes) {\n    let g = move || l;\n}\n"), [2]);
        assert_eq!(closure_lines("fn f<L>(l: L) where L: Lanes {\n    g(1, |x| x);\n}\n"), [2]);
        assert_eq!(closure_lines("impl<S: Simd> A<S> {\n    fn f(self) {\n        g(|x| x)\n    }\n}\n"), [3]);
    }

    #[test]
    fn scalar_functions_and_tests_may_use_closures() {
        assert!(closure_lines("fn f(a: &[u32]) { a.iter().map(|x| x + 1); }\nfn g<L: Lanes>() {}\n").is_empty());
        assert!(closure_lines("#[cfg(test)]\nmod tests { fn f<L: Lanes>() { a.map(|x| x); } }\n").is_empty());
    }

    #[test]
    fn bitwise_or_and_patterns_are_not_closures() {
        let text = "fn f<L: Lanes>(l: L) { let a = b | c; if d || e { g |= 1; } match h { | 1 | 2 => (a[0] | b), A { .. } | B { .. } => c(d) | e } }";
        assert!(closure_lines(text).is_empty());
    }

    #[test]
    fn inlined_closures_are_allowed() {
        assert!(closure_lines("fn f<S: Simd>(s: S) { s.vectorize(#[inline(always)] || g(s)); }").is_empty());
        assert_eq!(closure_lines("fn f<S: Simd>(s: S) { s.vectorize(#[inline] || g(s)); }").len(), 1);
    }

    #[test]
    fn function_types_in_headers_do_not_hide_the_body() {
        assert_eq!(closure_lines("fn f<L: Lanes>(g: fn(u32) -> u32, h: [u8; 4]) {\n    k(|x| x);\n}\n"), [2]);
    }

    #[test]
    fn fused_calls_are_found_and_definitions_are_not() {
        let text = "fn f() { a.mul_add(b, c); f32::mul_add(a, b, c); let mul_add = 1; }";
        assert_eq!(fused(&Tree::of(&[("crates/trigon/src/a.rs", text)])).len(), 2);
        assert!(fused(&Tree::of(&[("tests/src/a.rs", text)])).is_empty());
    }
}
