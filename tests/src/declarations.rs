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
    let mut text = format!("/// A chain of {rods} uniform rods.\npub {};\n", chain_name(rods, angles));
    let each = |line: &dyn Fn(usize) -> String| (1..=rods).map(line).collect::<Vec<_>>().join("\n");
    text += &format!("coordinates {{ {} }}\n{PARAMETERS}", each(&|i| format!("a{i} [rad];")));
    text += "let P0 = [0, 0];\n";
    text += &each(&|i| {
        let before = i - 1;
        let angle = match angles {
            Angles::Relative if i > 1 => format!("b{before} + a{i}"),
            _ => format!("a{i}"),
        };
        format!(
            "let b{i} = {angle};\nlet u{i} = [cos(b{i}), sin(b{i})];\n\
             let G{i} = P{before} + l/2*u{i};\nlet P{i} = P{before} + l*u{i};"
        )
    });
    let bodies = each(&|i| format!("rod{i}: mass m at G{i}, inertia m*l^2/12, angle b{i};"));
    text + &format!("\nbodies {{ {bodies} }}\nloads {{ gravity [0, -g]; }}\n")
}

/// `FourBars5` and the like.
pub fn four_bars_name(loops: usize) -> String {
    format!("FourBars{loops}")
}

/// N + 1 cranks side by side, joined by N couplers: problem A02 of the IFToMM benchmark library. Each loop is cut at the
/// tip of its second crank.
pub fn four_bars(loops: usize) -> String {
    let mut text = format!("/// {loops} four-bar linkages side by side.\npub {};\n", four_bars_name(loops));
    let cranks = |line: &dyn Fn(usize) -> String| (0..=loops).map(line).collect::<Vec<_>>().join("\n");
    let couplers = |line: &dyn Fn(usize) -> String| (1..=loops).map(line).collect::<Vec<_>>().join("\n");
    let coordinates = [cranks(&|i| format!("crank{i} [rad];")), couplers(&|i| format!("coupler{i} [rad];"))].join("\n");
    text += &format!("coordinates {{ {coordinates} }}\n{PARAMETERS}");
    text += &cranks(&|i| format!("let u{i} = l*[cos(crank{i}), sin(crank{i})];\nlet B{i} = [{i}*l, 0] + u{i};"));
    text += "\n";
    text += &couplers(&|i| format!("let w{i} = l*[cos(coupler{i}), sin(coupler{i})];"));
    let bodies = [
        cranks(&|i| format!("crank_rod{i}: mass m at [{i}*l, 0] + u{i}/2, inertia m*l^2/12, angle crank{i};")),
        couplers(&|i| format!("coupler_rod{i}: mass m at B{} + w{i}/2, inertia m*l^2/12, angle coupler{i};", i - 1)),
    ];
    let closed = couplers(&|i| format!("loop{i}: B{} + w{i} = B{i};", i - 1));
    let start = cranks(&|i| format!("guess crank{i} = pi/2;"));
    text + &format!(
        "\nbodies {{ {} }}\nloads {{ gravity [0, -g]; }}\nconstraints {{ {closed} }}\ninitial {{ {start} }}\n",
        bodies.join("\n")
    )
}
