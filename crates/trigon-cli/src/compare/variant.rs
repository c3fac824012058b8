//! The combinations of what is varied, each as the options of a command line.

use crate::failure::Failure;
use crate::options::{CompareOptions, Given, RenderCommandOptions, Written};
use crate::values::closest;
use clap::error::ErrorKind;
use std::ffi::OsString;
use trigon::target::SamplePattern;

/// One combination.
pub(crate) struct Variant {
    /// Names and values of what is varied, in the order of the axes.
    pub(crate) values: Vec<(String, String)>,
    /// What else is set for all: names and values.
    pub(crate) common: Vec<(String, String)>,
    pub(crate) options: RenderCommandOptions,
    pub(crate) given: Given,
    pub(crate) written: Written,
}

/// More pictures than anybody looks at.
const MAX_VARIANTS: usize = 256;

/// Every combination, the last axis the fastest.
pub(crate) fn variants(
    arguments: &[OsString],
    options: &CompareOptions,
    given: Given,
) -> Result<Vec<Variant>, Failure> {
    check_names(options)?;
    let count = options.axes.iter().fold(1_usize, |count, axis| count.saturating_mul(axis.values.len()));
    if count > MAX_VARIANTS {
        return Err(Failure::usage(format!("--vary makes {count} pictures; at most {MAX_VARIANTS} fit on a sheet")));
    }
    let common = common_values(options, given);
    let mut combinations: Vec<Vec<(String, String)>> = vec![Vec::new()];
    for axis in &options.axes {
        let with = |combination: &Vec<(String, String)>, value: &String| {
            let mut longer = combination.clone();
            longer.push((axis.name.clone(), value.clone()));
            longer
        };
        combinations = combinations.iter().flat_map(|c| axis.values.iter().map(move |value| with(c, value))).collect();
    }
    combinations.into_iter().map(|values| Variant::new(arguments, values, &common)).collect()
}

impl Variant {
    fn new(
        arguments: &[OsString],
        values: Vec<(String, String)>,
        common: &[(String, String)],
    ) -> Result<Self, Failure> {
        let all: Vec<(String, String)> = values.iter().chain(common).cloned().collect();
        let (options, given, written) = CompareOptions::with(arguments, &all).map_err(|error| {
            // A value that has commas in it was perhaps cut at them.
            let tip = match error.kind() {
                ErrorKind::ValueValidation => {
                    "\n  tip: --vary cuts values at commas, or where there are semicolons, at those alone\n"
                }
                _ => "",
            };
            Failure::Table(format!("{}{tip}", error.render()))
        })?;
        Ok(Self { values, common: common.to_vec(), options: options.render, given, written })
    }

    /// The same with these values in place of its own.
    pub(crate) fn with(&self, arguments: &[OsString], values: &[(String, String)]) -> Result<Self, Failure> {
        let common: Vec<(String, String)> = self.common.iter().chain(values).cloned().collect();
        Self::new(arguments, self.values.clone(), &common)
    }
}

fn names() -> Vec<String> {
    CompareOptions::variable_names()
}

fn check_names(options: &CompareOptions) -> Result<(), Failure> {
    let names = names();
    for (i, axis) in options.axes.iter().enumerate() {
        let name = &axis.name;
        if !names.contains(name) {
            let list = names.join(", ");
            let hint = closest(name, names.iter().map(String::as_str))
                .map_or(String::new(), |close| format!("; did you mean {close}?"));
            return Err(Failure::usage(format!("--vary: \"{name}\" cannot be varied{hint}\nThese can: {list}")));
        }
        if options.axes[..i].iter().any(|earlier| earlier.name == *name) {
            return Err(Failure::usage(format!("--vary: {name} comes twice; give all of its values at once")));
        }
    }
    Ok(())
}

/// The grid for all, where the standard pattern lacks some number of samples that a grid has, and nobody chose.
fn common_values(options: &CompareOptions, given: Given) -> Vec<(String, String)> {
    let is_varied = |name: &str| options.axes.iter().any(|axis| axis.name == name);
    let counts: Vec<u32> = options
        .axes
        .iter()
        .filter(|axis| axis.name == "samples")
        .flat_map(|axis| axis.values.iter().filter_map(|value| value.parse().ok()))
        .collect();
    let all = |pattern: fn(u32) -> Option<SamplePattern>| counts.iter().all(|count| pattern(*count).is_some());
    let needs_grid = !given.pattern && !is_varied("pattern") && !all(SamplePattern::standard);
    if needs_grid && all(SamplePattern::grid) { vec![("pattern".to_owned(), "grid".to_owned())] } else { Vec::new() }
}
