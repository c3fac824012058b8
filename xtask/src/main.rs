//! Chores of the trigon workspace: tidy, bless, assets.
fn main() {}
