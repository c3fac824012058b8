//! Whole-frame, golden and black-box tests of trigon.
