//! The direction of dependency between the crates (`docs/architecture.md`), read from `cargo metadata`.

use std::collections::{BTreeMap, BTreeSet};

use cargo_metadata::{DependencyKind, MetadataCommand};

/// What each crate may depend on, directly; what those may use, it may use too.
const LAYERS: &[(&str, &[&str])] = &[
    ("acrc-catalog", &[]),
    ("acrc-diagnostics", &[]),
    ("acrc-motion", &[]),
    ("acrc-trace", &[]),
    ("acrc-wire", &["acrc-catalog"]),
    ("acrc-syntax", &["acrc-catalog", "acrc-diagnostics"]),
    ("acrc-image", &["acrc-catalog"]),
    ("acrc-compile", &["acrc-syntax", "acrc-image"]),
    ("acrc-analysis", &["acrc-compile"]),
    ("acrc-lint", &["acrc-analysis"]),
    ("acrc-fmt", &["acrc-syntax"]),
    ("acrc-ide", &["acrc-lint", "acrc-fmt"]),
    ("acrc-lsp", &["acrc-ide"]),
    ("acrc-vm", &["acrc-image"]),
    ("acrc-controller", &["acrc-vm", "acrc-motion", "acrc-compile"]),
    ("acrc-store", &["acrc-controller"]),
    ("acrc-server", &["acrc-wire", "acrc-controller"]),
    ("acrc-link", &["acrc-wire", "acrc-analysis"]),
    ("acrc", &["acrc-lint", "acrc-fmt", "acrc-store", "acrc-trace", "acrc-server", "acrc-link", "acrc-lsp"]),
    ("tree-sitter-acrobasic", &[]),
    ("xtask", &["acrc-lint"]),
];

/// Outside crates that only one of ours may use.
const WRAPPED: &[(&str, &str)] = &[("salsa", "acrc-analysis"), ("logos", "acrc-syntax"), ("chumsky", "acrc-syntax")];

fn metadata() -> cargo_metadata::Metadata {
    MetadataCommand::new().no_deps().exec().expect("cargo tells the structure of the workspace")
}

fn allowed(name: &str, into: &mut BTreeSet<&'static str>) {
    let layers: BTreeMap<&str, &[&'static str]> = LAYERS.iter().copied().collect();
    for dependency in layers.get(name).copied().unwrap_or_default() {
        if into.insert(dependency) {
            allowed(dependency, into);
        }
    }
}

#[test]
fn every_crate_has_its_layer() {
    let known: BTreeSet<&str> = LAYERS.iter().map(|(name, _)| *name).collect();
    let members: BTreeSet<String> = metadata().packages.iter().map(|package| package.name.to_string()).collect();
    assert_eq!(known, members.iter().map(String::as_str).collect());
}

#[test]
fn dependencies_point_down() {
    for package in metadata().packages {
        let mut below = BTreeSet::new();
        allowed(&package.name, &mut below);
        for dependency in
            package.dependencies.iter().filter(|dependency| dependency.kind != DependencyKind::Development)
        {
            let ours = LAYERS.iter().any(|(name, _)| *name == dependency.name);
            assert!(
                !ours || below.contains(dependency.name.as_str()),
                "{} must not depend on {}: docs/architecture.md says what may",
                package.name,
                dependency.name
            );
        }
    }
}

#[test]
fn wrapped_crates_stay_wrapped() {
    for package in metadata().packages {
        for (outside, owner) in WRAPPED {
            let uses = package.dependencies.iter().any(|dependency| dependency.name == *outside);
            assert!(!uses || package.name.as_str() == *owner, "only {owner} may use {outside}, not {}", package.name);
        }
    }
}

#[test]
fn nothing_but_tests_draws_on_the_whole() {
    // The catalogue, the motion core and the trace are for other tools too: they bring nothing of ours along.
    for name in ["acrc-catalog", "acrc-motion", "acrc-trace", "acrc-diagnostics"] {
        let mut below = BTreeSet::new();
        allowed(name, &mut below);
        assert!(below.is_empty(), "{name}");
    }
}
