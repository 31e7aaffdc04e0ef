//! Random sound declarations in space, without units, which would have to fit.

use crate::expression::Known;
use crate::table::tables;

/// The text of a declaration whose mechanism has this name.
pub(crate) fn declaration(name: &str, seed: usize) -> String {
    Space { known: Known::new(seed, 3), bodies: vec![], hanging: vec![] }.declaration(name)
}

struct Space {
    known: Known,
    /// Those with an attitude.
    bodies: Vec<String>,
    /// Joints that place bodies, in a chain.
    hanging: Vec<&'static str>,
}

/// Joints, and what the coordinates that they become are called after their names.
const JOINTS: [(&str, &[&str]); 8] = [
    ("ball", &["_q0", "_q1", "_q2", "_q3"]),
    ("revolute", &[""]),
    ("universal", &["_1", "_2"]),
    ("cylindrical", &["_turn", "_shift"]),
    ("prismatic", &[""]),
    ("screw", &[""]),
    ("planar", &["_x", "_y", "_turn"]),
    ("weld", &[]),
];

impl Space {
    fn declaration(&mut self, name: &str) -> String {
        let count = 1 + self.known.random.below(2);
        let mut text = format!("pub {name};\ncoordinates {{ repeat i in 1..={count} {{ q_[i]; }} }}\n");
        self.known.coordinates = (1..=count).map(|i| format!("q_{i}")).collect();
        self.known.scalars.extend(self.known.coordinates.clone());
        text += &self.known.parameters();
        text += &self.known.named_scalars(1);
        text += &self.known.named_rotations(2);
        text += &self.known.named_vectors(2);
        text += &tables(&mut self.known.random);
        text += "auxiliary { cut; } inputs { drive = sin(0.7*t)/2; }\n";
        text += &self.bodies();
        let constraints = self.known.constraints();
        text += &constraints.block;
        text += &self.tree();
        let loops = self.loops();
        text += &loops.0;
        text += &self.loads();
        text += &self.known.events(&constraints.switched);
        text += &self.outputs(&constraints.names, &loops.1);
        // Derivatives in space are long, and so are made of a few.
        text + if self.known.random.once_in(4) {
            "kernels { dynamics_jacobian; dynamics_sensitivity; inverse_dynamics; }\n"
        } else {
            "kernels { inverse_dynamics; }\n"
        }
    }

    /// Every coordinate has a mass of its own, so that the mass matrix has full rank.
    fn bodies(&mut self) -> String {
        let mut text = String::from("bodies {\n");
        for (i, coordinate) in self.known.coordinates.clone().iter().enumerate() {
            let (y, z) = (self.known.scalar(1), self.known.scalar(0));
            text += &format!("own{i}: mass 1.3 at [{coordinate}, {y}, {z}];\n");
        }
        for i in 0..1 + self.known.random.below(2) {
            let (at, inertia) = (self.known.vector(1), self.inertia());
            let attitude = self.known.random.pick(&self.known.rotations).clone();
            text += &format!("turned{i}: mass p1 at {at} + [cut, 0, q_1], inertia {inertia}, attitude {attitude};\n");
            self.bodies.push(format!("turned{i}"));
        }
        if self.known.random.once_in(2) {
            let (body, angle) = (self.known.random.pick(&self.bodies).clone(), self.known.scalar(1));
            let (at, inertia) = (self.point(), self.inertia());
            text += &format!(
                "rider: mass 0.7 at on({body}, {at}), inertia {inertia}, attitude attitude({body})*rotation(y, {angle});\n"
            );
            self.bodies.push("rider".into());
        }
        if self.known.random.once_in(2) {
            text +=
                &format!("loose: free, mass {}, inertia {};\n", self.known.random.pick(&["p3", "0.9"]), self.inertia());
            self.bodies.push("loose".into());
            let own = ["x", "y", "z", "q0", "q1", "q2", "q3"].map(|name| format!("loose_{name}"));
            self.known.scalars.extend(own);
        }
        text + "}\n"
    }

    /// Principal moments or the whole tensor of a body that could be: J = tr(P) - P, where P is positive definite.
    fn inertia(&mut self) -> String {
        let [a, b, c] = [(); 3].map(|()| self.known.random.between(0.1, 0.5));
        let principal = format!("{:.3}, {:.3}, {:.3}", b + c, c + a, a + b);
        if self.known.random.once_in(2) {
            return format!("[{principal}]");
        }
        let most = 0.4 * a.min(b).min(c);
        let [xy, xz, yz] = [(); 3].map(|()| self.known.random.between(-most, most));
        format!("[{principal}, {xy:.3}, {xz:.3}, {yz:.3}]")
    }

    /// Up to two bodies in a chain from anywhere, placed by their joints.
    fn tree(&mut self) -> String {
        let mut text = String::new();
        let mut from = self.anywhere();
        for i in 0..self.known.random.below(3) {
            // Welded to the ground nothing moves it, which is a mistake.
            let (kind, suffixes) = *self.known.random.pick(if from == "ground" { &JOINTS[..7] } else { &JOINTS });
            let (name, body) = (format!("hang{i}"), format!("hung{i}"));
            text += &format!("bodies {{ {body}: mass 1.1, inertia {}; }}\n", self.inertia());
            text += &format!("joints {{ {} }}\n", self.joint(&name, kind, &from, &body));
            let own = suffixes.iter().map(|suffix| format!("{name}{suffix}"));
            self.known.coordinates.extend(own.clone());
            self.known.scalars.extend(own);
            self.hanging.push(kind);
            self.bodies.push(body.clone());
            from = body;
        }
        text
    }

    /// Joints between bodies that have their places, which are constraints, and those of them that have a force.
    fn loops(&mut self) -> (String, Vec<String>) {
        let (mut text, mut forces) = (String::from("joints {\n"), vec![]);
        if self.bodies.iter().any(|body| body == "loose") && !self.known.random.once_in(4) {
            let others: Vec<String> = self.bodies.iter().filter(|body| *body != "loose").cloned().collect();
            let other = self.known.random.pick(&others).clone();
            match self.known.random.below(10) {
                8 => text += "rolls: roll loose radius 0.4 axis [0, 1, 0] on [0, 0.2, 0] normal [0, 0.6, 0.8];\n",
                9 => {
                    let (own, far) = (self.point(), self.point());
                    text += &format!("tie: link on(loose, {own}) to on({other}, {far}) + [9, 7, 0], length 5;\n");
                    forces.push("tie".to_owned());
                }
                kind => {
                    let kind = JOINTS[kind].0;
                    text += &self.joint("closed", kind, &other, "loose");
                    if ["ball", "revolute", "universal", "weld"].contains(&kind) {
                        forces.push("closed".to_owned());
                    }
                }
            }
        }
        // A tip on two joints that can be anywhere near: the third takes three of its coordinates.
        let hangs_by = |kind| self.hanging.contains(&kind);
        if self.hanging.len() == 2 && (hangs_by("ball") || hangs_by("universal")) && !hangs_by("weld") {
            let tip = self.bodies[self.bodies.len() - 1].clone();
            text += &self.joint("stay", "ball", "ground", &tip);
            forces.push("stay".to_owned());
        }
        (text + "}\n", forces)
    }

    /// Either side first, with axes of all kinds.
    fn joint(&mut self, name: &str, kind: &str, first: &str, second: &str) -> String {
        let mut side = |body: &str| format!("{body} at {}{}", self.point(), self.axis());
        let (first, second) = (side(first), side(second));
        let (first, second) = if self.known.random.once_in(2) { (first, second) } else { (second, first) };
        let pitch = if kind == "screw" { " pitch p2/2" } else { "" };
        format!("{name}: {kind} {first} to {second}{pitch};\n")
    }

    fn axis(&mut self) -> String {
        const AXES: [&str; 8] = [
            "",
            " axis [1, 0, 0]",
            " axis [0, 1, 0]",
            " axis [0, 0, 1]",
            " axis [0, -1, 0]",
            " axis [0.6, 0, 0.8]",
            " axis [0.48, -0.6, 0.64]",
            " axis [0, sin(p3), cos(p3)]",
        ];
        self.known.random.pick(&AXES).to_string()
    }

    /// In the frame of a body.
    fn point(&mut self) -> String {
        let [x, y] = [(); 2].map(|()| self.known.random.between(-0.6, 0.6));
        match self.known.random.below(3) {
            0 => format!("[{x:.2}, 0, 0]"),
            1 => format!("[0, {x:.2}, {y:.2}]"),
            _ => format!("[{x:.2}, p1/4, {y:.2}]"),
        }
    }

    fn anywhere(&mut self) -> String {
        match self.known.random.once_in(3) {
            true => "ground".into(),
            false => self.known.random.pick(&self.bodies).clone(),
        }
    }

    fn loads(&mut self) -> String {
        let mut text = String::from("loads { gravity [0.3*t, 0, -9.81]; force drive on q_1;\n");
        for _ in 0..1 + self.known.random.below(3) {
            let (body, at) = (self.known.random.pick(&self.bodies).clone(), self.point());
            let (rate, vector) = (self.known.rate(1), self.known.vector(1));
            text += &match self.known.random.below(7) {
                0 => format!("force [{rate}, 0.2, -0.1] at on({body}, {at});\n"),
                1 => format!("force attitude({body})*{vector} at on({body}, {at});\n"),
                2 => format!("torque {vector} - 0.3*omega({body}) on {body};\n"),
                3 => format!("torque attitude({body})*[0, {rate}, 0.4] on {body};\n"),
                4 => format!("spring p2, length 0.5 from [9, 7, 8] + {vector}/9 to on({body}, {at});\n"),
                5 => format!("damper p1 from [9, -7, 8] to on({body}, {at});\n"),
                _ => format!("force {rate}*dot(on({body}, {at})) at {vector};\n"),
            };
        }
        for _ in 0..self.known.random.below(3) {
            text += &self.known.element();
        }
        text + "}\n"
    }

    fn outputs(&mut self, constraints: &[String], forces: &[String]) -> String {
        let mut text = String::from("outputs { force = reaction(cut);\n");
        for (i, body) in self.bodies.clone().iter().enumerate() {
            let (at, vector, axis) = (self.point(), self.known.vector(1), self.known.random.pick(&["x", "y", "z"]));
            let output = match self.known.random.below(7) {
                0 => format!("norm(omega({body}))"),
                1 => format!("(transpose(attitude({body}))*omega({body})).{axis}"),
                2 => format!("cross(on({body}, {at}), {vector}).{axis}"),
                3 => format!("inner(attitude({body})*{vector}, dot(on({body}, {at})))"),
                4 => format!("ddot(on({body}, {at})).{axis}"),
                5 => format!("dot(omega({body})).{axis}"),
                _ => format!("angular_velocity({}*transpose(attitude({body}))).{axis}", self.known.rotations[0]),
            };
            text += &format!("of_{i} = {output};\n");
        }
        for name in constraints {
            text += &format!("r_{name} = reaction({name});\n");
        }
        for name in forces {
            let value = if name == "tie" { "reaction(tie)" } else { &format!("norm(reaction({name}))") };
            text += &format!("r_{name} = {value};\n");
        }
        text + "}\n"
    }
}
