//! Motions against solutions that this code did not make.

#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod andrews;
mod assembly;
mod auxiliary;
mod cams;
mod cart_pole;
mod chains;
mod constraints;
mod elements;
mod events;
mod failure;
mod faulty;
mod half_car;
mod hidden_pulses;
mod impacts;
mod inputs;
mod joints;
mod leaps;
mod linkages;
mod marks;
mod near_zero;
mod nonholonomic;
mod order;
mod owner;
mod pendulum;
mod pushes;
mod quick_return;
mod records;
mod scaled;
mod simulation;
mod singular;
mod singular_start;
mod six_bar;
mod slipping;
mod small;
mod smooth_pulses;
mod sparse;
mod statics;
mod stiff;
mod sudden;
mod undefined;
mod units;
mod verification;
mod work;
mod yokes;
