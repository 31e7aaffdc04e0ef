//! Kernels and steps do not allocate.

#![allow(unsafe_code)]

use crate::mechanisms::{Cart, Functions};
use models::QuickReturn;
use sim::{Array, Mechanism, RK4, assemble, declared_start, integrate};
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
    fn all_kernels<M: Mechanism>(mechanism: M) {
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
        black_box((mechanism.events(t, &q, &qd), mechanism.drawing(t, &q)));
    }
    assert_eq!(allocations(|| all_kernels(QuickReturn::default())), 0);
    assert_eq!(allocations(|| all_kernels(Cart::default())), 0);
    assert_eq!(allocations(|| all_kernels(Functions::default())), 0);
}

#[test]
fn ten_thousand_steps_do_not_allocate() {
    let mechanism = QuickReturn::default();
    let start = assemble(&mechanism, &declared_start(&mechanism)).unwrap();
    let mut samples = Vec::with_capacity(10_001);
    let counted = allocations(|| {
        integrate(&mechanism, &RK4, start, 2.0, 10_000, |sample| samples.push(sample)).unwrap();
    });
    assert_eq!((counted, samples.len()), (0, 10_001));
}
