//! The programs of a mechanism, derived from its declaration.

use super::blocks::OfMany;
use super::execute::{Given, image};
use super::leaked::{Kept, kept};
use super::one_program::OneProgram;
use super::registers::{Number, with_registers};
use crate::model::erased::{Found, Results, States};
use codegen::Derived;
use codegen::emit::bytecode::{Order, codes};
use codegen::kernel_id::KernelId;
use codegen::symbolic::evaluate;
use sim_kernel::{Description, Mask, Scalar, Table, Vectors};

/// The programs of a mechanism, and what is told of it.
#[derive(Debug)]
pub(super) struct Programs {
    pub(super) description: &'static Description,
    /// Where generalised speeds are declared, the constraints that they leave.
    pub(super) rows_left: Option<&'static [usize]>,
    /// Declared values of parameters.
    pub(super) defaults: Vec<f64>,
    pub(super) tables: &'static [Table],
    /// By the number of the kernel.
    programs: Vec<Option<OneProgram>>,
}

impl Programs {
    pub(super) fn new(derived: &Derived) -> Programs {
        let Derived { equations, program, .. } = derived;
        let Kept { description, tables, rows_left } = kept(derived);
        let (model, graph) = (&equations.model, &equations.graph);
        let defaults: Vec<_> = model.parameters.iter().map(|parameter| parameter.default).collect();
        let mut by_number: Vec<Option<OneProgram>> = KernelId::ALL.iter().map(|_| None).collect();
        let [written, scheduled] = [Order::Written, Order::Scheduled].map(|order| codes(model, program, order));
        for (code, scheduled) in written.into_iter().zip(scheduled) {
            let number = code.kernel as usize;
            by_number[number] = Some(OneProgram::new(code, scheduled));
        }
        Programs {
            description,
            rows_left,
            defaults: evaluate(graph, &defaults, |_| f64::NAN),
            tables,
            programs: by_number,
        }
    }

    pub(super) fn has(&self, kernel: KernelId) -> bool {
        self.programs[kernel as usize].is_some()
    }

    /// What a kernel begins with: it does not change while the mechanism's values do not.
    pub(super) fn image<S: Scalar>(&self, kernel: KernelId, given: &Given<S>) -> Vec<S> {
        let program = &self.programs[kernel as usize];
        program.as_ref().map_or_else(Vec::new, |program| image(&program.code, given))
    }

    /// Executes a kernel, and gives the rows of its results.
    pub(super) fn call<S: Number>(&self, kernel: KernelId, given: &Given<S>, found: Found<S>) -> bool {
        self.call_from(kernel, &self.image(kernel, given), given, found)
    }

    /// Executes a kernel that begins with an image, and gives the rows of its results. True if it refuses a pivot. Nothing is
    /// given of a kernel that there is not, which is refused.
    pub(super) fn call_from<S: Number>(
        &self,
        kernel: KernelId,
        image: &[S],
        given: &Given<S>,
        found: Found<S>,
    ) -> bool {
        let Some(program) = &self.programs[kernel as usize] else { return true };
        let places = S::places(program);
        with_registers(places.room, |registers| {
            S::execute(program, image, given, registers);
            places.rows.iter().enumerate().for_each(|(row, range)| found(row, &registers[range.clone()]));
            places.refused(|register| registers[register as usize]).any()
        })
    }

    /// A kernel's results at many states; none of a kernel that there is not.
    pub(super) fn call_each(
        &self,
        (vectors, kernel): (Vectors, KernelId),
        given: &Given<f64>,
        states: &States,
    ) -> Option<Results> {
        let OneProgram { code, places, .. } = self.programs[kernel as usize].as_ref()?;
        let image = image(code, given);
        Some(vectors.run(OfMany { code, places, image: &image, inputs: given.inputs, tables: given.tables, states }))
    }

    /// All results of a kernel, one after the other.
    pub(super) fn list<S: Number>(&self, kernel: KernelId, given: &Given<S>) -> Vec<S> {
        let mut list = Vec::new();
        self.call(kernel, given, &mut |_, row| list.extend_from_slice(row));
        list
    }
}
