//! Declarations through rustc: what it shows where, and that one mistake shows once.

#![allow(missing_docs)]

#[test]
fn declarations_through_rustc() {
    let cases = trybuild::TestCases::new();
    cases.pass("../../tests/language/pass/*.rs");
    cases.compile_fail("../../tests/language/fail/*.rs");
}
