//! Mechanisms in space: their kernels against the oracle and Lagrange's equations, and their motion against closed forms.

#![allow(missing_docs, clippy::unwrap_used)]

mod all;
mod mechanisms;

#[path = "../kernels/evaluation.rs"]
mod evaluation;
#[path = "../kernels/lagrange.rs"]
mod lagrange;
#[path = "../kernels/oracle.rs"]
mod oracle;

mod arm;
mod cardan;
mod common;
mod elliptic;
mod gyroscope;
mod integrated_speeds;
mod joints_by_hand;
mod linkages;
mod rolling;
mod speeds;
mod top;
mod torque_free;
mod tree;
