//! `cargo xtask tidy`: the rules of this workspace that neither the compiler nor clippy can hold.
//!
//! In: the files of the tree and `cargo metadata`. Out: findings, each with its place, the rule, the reason for the
//! rule and what to do. Each rule is a pure function from a [`tree::Tree`] to findings, so that it can be tested on
//! a tree made of strings.

mod check;
mod contents;
mod edges;
mod files;
mod finding;
mod lanes;
mod licences;
mod markdown;
mod stages;
mod tokens;
mod tree;
mod unfinished;
mod unsafety;
mod words;

pub(crate) use check::run;
