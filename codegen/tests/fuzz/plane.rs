//! Random sound declarations in the plane, without units, which would have to fit.

use crate::expression::Known;
use crate::table::tables;

/// The text of a declaration whose mechanism has this name.
pub(crate) fn declaration(name: &str, seed: usize) -> String {
    Plane { known: Known::new(seed, 2) }.declaration(name)
}

struct Plane {
    known: Known,
}

impl Plane {
    fn declaration(&mut self, name: &str) -> String {
        let mut text = format!("pub {name};\n");
        let count = 1 + self.known.random.below(4);
        text += &self.coordinates(count);
        text += &self.known.parameters();
        let scalars = self.known.random.below(4);
        text += &self.known.named_scalars(scalars);
        let vectors = 1 + self.known.random.below(3);
        text += &self.known.named_vectors(vectors);
        if self.known.random.once_in(2) {
            text += &self.fragment();
        }
        text += &tables(&mut self.known.random);
        text += "auxiliary { cut; } inputs { drive = sin(0.7*t)/2; }\n";
        text += &self.bodies();
        text += &self.loads();
        let constraints = self.known.constraints();
        text += &constraints.block;
        if self.known.random.once_in(3) {
            text += &self.joints();
        }
        text += &self.known.events(&constraints.switched);
        text += &self.outputs(&constraints.names);
        text + "kernels { dynamics_jacobian; dynamics_sensitivity; inverse_dynamics; }\n"
    }

    fn coordinates(&mut self, count: usize) -> String {
        let text = match self.known.random.below(2) {
            0 => format!("coordinates {{ repeat i in 1..={count} {{ q_[i]; }} }}\n"),
            _ => (1..=count).map(|i| format!("coordinates {{ q_{i}; }}\n")).collect(),
        };
        self.known.coordinates = (1..=count).map(|i| format!("q_{i}")).collect();
        self.known.scalars.extend(self.known.coordinates.clone());
        text
    }

    /// A fragment with a coordinate, a body and a name of its own, used once or in a row.
    fn fragment(&mut self) -> String {
        let text = format!(
            "fragment Arm(base, size) {{
                coordinates {{ a; }} parameters {{ m = {:.2}; l = 1.1; }}
                let tip = base + size*l*[cos(a), sin(a)];
                bodies {{ tip_mass: mass m at tip, inertia {:.2}, angle a; }}
            }}\n",
            self.known.random.between(0.5, 2.0),
            self.known.random.between(0.1, 0.4)
        );
        let arms = if self.known.random.once_in(2) {
            let base = self.known.vector(1);
            let size = self.known.random.below(2) + 1;
            self.named_arm("arm");
            format!("use Arm({base}, {size}) as arm;\n")
        } else {
            let (base, size) = (self.known.random.pick(&self.known.vectors).clone(), self.known.scalar(0));
            let text = format!(
                "use Arm({base}, 1) as arm_0;
                repeat i in 1..2 {{ use Arm(arm_[i-1]_tip, {size}) as arm_[i]; }}\n"
            );
            (0..2).for_each(|i| self.named_arm(&format!("arm_{i}")));
            text
        };
        text + &arms
    }

    fn named_arm(&mut self, arm: &str) {
        self.known.scalars.push(format!("{arm}_a"));
        self.known.coordinates.push(format!("{arm}_a"));
        self.known.vectors.push(format!("{arm}_tip"));
    }

    /// Every coordinate has a mass of its own, so that the mass matrix has full rank.
    fn bodies(&mut self) -> String {
        let mut text = String::from("bodies {\n");
        for (i, coordinate) in self.known.coordinates.clone().iter().enumerate() {
            let mass = self.known.random.between(0.5, 2.0);
            let cut = if i == 0 { " + cut" } else { "" };
            text += &format!("own{i}: mass {mass:.2} at [{coordinate}{cut}, {}], ", self.known.scalar(1));
            text += &format!("inertia 0.1, angle {coordinate};\n");
        }
        for i in 0..self.known.random.below(3) {
            let (mass, inertia) =
                (self.known.random.pick(&["p1", "p2*p3", "2"]), self.known.random.pick(&["p2", "0", "p1^2/12"]));
            let (at, angle) = (self.known.vector(2), self.known.scalar(2));
            text += &format!("body{i}: mass {mass} at {at} + [cut + q_1, 0], inertia {inertia}, angle {angle};\n");
        }
        text + "}\n"
    }

    fn loads(&mut self) -> String {
        let mut text = String::from("loads { gravity [0, -9.81]; force drive on q_1;\n");
        for _ in 0..self.known.random.below(3) {
            let (x, y, at) = (self.known.rate(2), self.known.scalar(2), self.known.vector(1));
            text += &format!("force [{x}, {y}] at {at};\n");
        }
        if self.known.random.once_in(2) {
            text += &format!("torque {} on own0;\n", self.known.rate(2));
        }
        for _ in 0..self.known.random.below(3) {
            text += &self.known.element();
        }
        text + "}\n"
    }

    /// A rod that hangs on a pin, perhaps turned by a gear: coordinates of its own.
    fn joints(&mut self) -> String {
        let at = self.known.vector(2);
        let gear = *self.known.random.pick(&["", "mesh: gear own0 radius 0.4 to rod radius 0.7;"]);
        format!(
            "bodies {{ rod: free, mass 1.3, inertia 0.2; }}
            joints {{ pivot: pin on(rod, [0.4, -0.1]) to {at}; {gear} }}
            loads {{ force [0, 0.3] at on(rod, [-0.4, 0]); }}\n"
        )
    }

    fn outputs(&mut self, constraints: &[String]) -> String {
        let mut text = format!(
            "outputs {{ rate = {}; second = ddot({}); force = reaction(cut); ",
            self.known.rate(2),
            self.known.scalar(2)
        );
        for constraint in constraints {
            text += &format!("r_{constraint} = reaction({constraint})*{}; ", self.known.scalar(0));
        }
        let count = self.known.coordinates.iter().filter(|name| name.starts_with("q_")).count();
        text += &format!("all = sum(i in 1..={count}, i*q_[i]^2);");
        text + "}\n"
    }
}
