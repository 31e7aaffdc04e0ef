//! Kernels and steps do not allocate.

#![allow(unsafe_code)]

use crate::mechanisms::{Cart, Functions};
use models::QuickReturn;
use sim::{
    Advance, Compiled, Course, Dop853, EventSearch, ExplicitRungeKutta, FixedArray, Measures, Motion, RK4, Radau5,
    Stabilisation, State, Stepping, Steps, Tolerance, assemble, declared_start, integrate,
};
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::hint::black_box;

struct Counting;

thread_local! {
    static ALLOCATIONS: Cell<usize> = const { Cell::new(0) };
}

// Safety: every call goes to the system's allocator unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ALLOCATIONS.with(|count| count.set(count.get() + 1));
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static COUNTING: Counting = Counting;

fn allocations(f: impl FnOnce()) -> usize {
    let before = ALLOCATIONS.with(Cell::get);
    f();
    ALLOCATIONS.with(Cell::get) - before
}

#[test]
fn the_counter_counts() {
    assert!(allocations(|| drop(black_box(vec![1]))) > 0);
}

#[test]
fn kernels_do_not_allocate() {
    fn all_kernels<M: Compiled>(mechanism: M) {
        let (t, q, qd) = (0.1, M::Q::filled(0.3), M::Q::filled(0.2));
        let lambda = M::L::filled(1.0);
        black_box(mechanism.initial());
        black_box((
            mechanism.dynamics(t, &q, &qd),
            mechanism.mass_matrix(t, &q),
            mechanism.convective_forces(t, &q, &qd),
        ));
        black_box((
            mechanism.generalized_forces(t, &q, &qd),
            mechanism.constraints(t, &q),
            mechanism.constraint_jacobian(t, &q),
        ));
        black_box((mechanism.constraint_convective(t, &q, &qd), mechanism.constraint_linearization(t, &q)));
        black_box((mechanism.constraint_magnitudes(t, &q), mechanism.constraint_time_derivative(t, &q)));
        black_box((mechanism.kinetic_energy(t, &q, &qd), mechanism.power(t, &q, &qd, &qd, &lambda)));
        black_box((mechanism.outputs(t, &q, &qd, &qd, &lambda), mechanism.output_rates(t, &q, &qd, &qd)));
        black_box((mechanism.events(t, &q, &qd, &qd, &lambda), mechanism.drawing(t, &q)));
    }
    assert_eq!(allocations(|| all_kernels(QuickReturn::default())), 0);
    assert_eq!(allocations(|| all_kernels(Cart::default())), 0);
    assert_eq!(allocations(|| all_kernels(Functions::default())), 0);
}

/// Ten thousand steps of each kind, with projection, events and dense output.
#[test]
fn ten_thousand_steps_do_not_allocate() {
    let mechanism = QuickReturn::default();
    let start = assemble(&mechanism, &declared_start(&mechanism)).unwrap();
    for stabilisation in [Stabilisation::Projection, Stabilisation::MassProjection, Stabilisation::Partitioning] {
        let equal = Stepping::Equal(10_000);
        ten_thousand_steps(
            &mechanism,
            ExplicitRungeKutta::new(&mechanism, &RK4),
            stabilisation,
            equal,
            2.0,
            start.clone(),
        );
        ten_thousand_steps(&mechanism, Dop853::new(&mechanism), stabilisation, equal, 20.0, start.clone());
    }
    let equal = Stepping::Equal(10_000);
    ten_thousand_steps(&mechanism, Radau5::new(&mechanism), Stabilisation::Projection, equal, 20.0, start.clone());
    let adaptive = Stepping::Adaptive(Tolerance::new(1e-12));
    ten_thousand_steps(&mechanism, Dop853::new(&mechanism), Stabilisation::Projection, adaptive, 400.0, start);
}

fn ten_thousand_steps<A: Advance<QuickReturn>>(
    mechanism: &QuickReturn,
    mut method: A,
    stabilisation: Stabilisation,
    stepping: Stepping,
    end: f64,
    start: State<QuickReturn>,
) {
    let measures = Measures::at(mechanism, start.time, &start.positions);
    let motion = Motion::new(*mechanism, stabilisation, measures);
    motion.start(&start);
    let first = motion.sample(start).unwrap();
    let mut events = EventSearch::new(mechanism, [0.0, 1.0]);
    let mut steps = Steps::default();
    let course = Course { begin: 0.0, end, stepping };
    let counted = allocations(|| {
        integrate(&motion, &mut method, &course, first, &mut steps, |step| {
            events.search(step)?;
            black_box(step.at(step.from.state.time + 0.3 * step.length())?);
            Ok(std::ops::ControlFlow::Continue(()))
        })
        .unwrap();
    });
    assert!(counted == 0 && steps.accepted >= 10_000 && events.found.len() == 1, "{counted} {steps:?} {stabilisation}");
}
