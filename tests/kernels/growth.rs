//! How the operations of `dynamics` grow with the mechanism: twice as many bodies take about twice as many, whether
//! long sums are cut (chains) or the order of elimination finds the band (four-bars side by side).

use codegen::dynamics::derive_cheapest;
use codegen::kernel_id::KernelId;
use codegen::{model, program};
use tests::declarations::{Angles, chain, four_bars};

#[test]
fn twice_the_bodies_take_twice_the_operations() {
    type Declaration = fn(usize) -> String;
    let mechanisms: [(&str, Declaration); 3] = [
        ("chain, absolute angles", |n| chain(n, Angles::Absolute)),
        ("chain, relative angles", |n| chain(n, Angles::Relative)),
        ("four-bars", four_bars),
    ];
    for (name, declaration) in mechanisms {
        let [few, many] = [10, 20].map(|bodies| operations(&declaration(bodies)));
        println!("{name:<24} {few} and {many} operations");
        // A cost that grows with the square would give 4.
        assert!(many < few * 5 / 2, "{name}: {few}, {many}");
    }
}

fn operations(declaration: &str) -> usize {
    let declaration = codegen::parse(declaration.parse().unwrap()).unwrap();
    let mut equations = derive_cheapest(model::resolve(&declaration).unwrap());
    let program = program::plan(&mut equations);
    program.kernels.iter().find(|kernel| kernel.id == KernelId::Dynamics).unwrap().operations.total()
}
