//! The Python module `linkwright._linkwright`: declarations read and executed at run time, for the package that is around it.

mod answer;
mod errors;
mod interrupt;
mod kernels;
mod model;
mod robots;
mod shapes;
mod shipped;
mod simulation;

use pyo3::prelude::*;

#[pymodule]
mod _linkwright {
    #[pymodule_export]
    use crate::answer::Answer;
    #[pymodule_export]
    use crate::model::{Model, from_text, in_unit, read};
    #[pymodule_export]
    use crate::robots::import_robot;
    #[pymodule_export]
    use crate::shipped::{main, shipped};
    #[pymodule_export]
    use crate::simulation::Simulation;
}
