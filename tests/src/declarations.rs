//! Declarations of mechanisms of any size, as text, and the sizes that benchmarks take. The build script reads this file
//! too.

/// Rods of the chains that are measured.
pub const CHAIN_SIZES: &[usize] = &[2, 5, 10, 20, 40, 60];
/// Loops of the N-four-bar mechanisms that are measured.
pub const FOUR_BAR_SIZES: &[usize] = &[1, 2, 5, 10, 20, 40];

/// How the angles of a chain are measured.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Angles {
    /// From the ground.
    Absolute,
    /// From the rod before.
    Relative,
}

const PARAMETERS: &str = "parameters { m [kg] = 1; l [m] = 1; g [m/s^2] = 9.81; }\n";

/// `ChainAbsolute5` and the like.
pub fn chain_name(rods: usize, angles: Angles) -> String {
    format!("Chain{angles:?}{rods}")
}

/// A chain of equal uniform rods that hangs from the ground.
pub fn chain(rods: usize, angles: Angles) -> String {
    let name = chain_name(rods, angles);
    let turned = match angles {
        Angles::Absolute => "a_[i]",
        Angles::Relative => "b_[i-1] + a_[i]",
    };
    format!(
        "/// A chain of {rods} uniform rods.
        pub {name};
        const n = {rods};
        coordinates {{ repeat i in 1..=n {{ a_[i] [rad]; }} }}
        {PARAMETERS}
        let P_[0] = [0, 0];
        let b_[0] = 0;
        repeat i in 1..=n {{
            let b_[i] = {turned};
            let u_[i] = [cos(b_[i]), sin(b_[i])];
            let P_[i] = P_[i-1] + l*u_[i];
            bodies {{ rod_[i]: mass m at P_[i-1] + l/2*u_[i], inertia m*l^2/12, angle b_[i]; }}
        }}
        loads {{ gravity [0, -g]; }}"
    )
}

/// Rods of the chains of free bodies that are measured beside those in angles.
pub const FREE_CHAIN_SIZES: &[usize] = &[20, 100];

/// `ChainFree5` and the like.
pub fn free_chain_name(rods: usize) -> String {
    format!("ChainFree{rods}")
}

/// The same chain with absolute angles, each rod a free body.
pub fn free_chain(rods: usize) -> String {
    let name = free_chain_name(rods);
    format!(
        "/// A chain of {rods} uniform rods, each a free body.
        pub {name};
        const n = {rods};
        {PARAMETERS}
        let P_[0] = [0, 0];
        repeat i in 1..=n {{
            bodies {{ rod_[i]: free, mass m, inertia m*l^2/12; }}
            let P_[i] = on(rod_[i], [l/2, 0]);
            joints {{ pin_[i]: pin P_[i-1] to on(rod_[i], [-l/2, 0]); }}
        }}
        loads {{ gravity [0, -g]; }}"
    )
}

/// `FourBars5` and the like.
pub fn four_bars_name(loops: usize) -> String {
    format!("FourBars{loops}")
}

/// N + 1 cranks side by side, joined by N couplers: problem A02 of the IFToMM benchmark library. Each loop is cut at the
/// tip of its second crank.
pub fn four_bars(loops: usize) -> String {
    let name = four_bars_name(loops);
    format!(
        "/// {loops} four-bar linkages side by side.
        pub {name};
        const N = {loops};
        coordinates {{
            repeat i in 0..=N {{ crank_[i] [rad]; }}
            repeat i in 1..=N {{ coupler_[i] [rad]; }}
        }}
        {PARAMETERS}
        repeat i in 0..=N {{
            let u_[i] = l*[cos(crank_[i]), sin(crank_[i])];
            let B_[i] = [i*l, 0] + u_[i];
            bodies {{ crank_rod_[i]: mass m at [i*l, 0] + u_[i]/2, inertia m*l^2/12, angle crank_[i]; }}
        }}
        repeat i in 1..=N {{
            let w_[i] = l*[cos(coupler_[i]), sin(coupler_[i])];
            bodies {{ coupler_rod_[i]: mass m at B_[i-1] + w_[i]/2, inertia m*l^2/12, angle coupler_[i]; }}
            constraints {{ loop_[i]: B_[i-1] + w_[i] = B_[i]; }}
        }}
        loads {{ gravity [0, -g]; }}
        initial {{ repeat i in 0..=N {{ guess crank_[i] = pi/2; }} }}"
    )
}
