//! Random sound declarations, without units, which would have to fit.

use crate::random::Random;

/// The text of a declaration whose mechanism has this name.
pub(crate) fn declaration(name: &str, seed: usize) -> String {
    let mut writer = Writer { random: Random::new(seed), scalars: vec![], vectors: vec![], coordinates: vec![] };
    writer.declaration(name)
}

struct Writer {
    random: Random,
    /// What can stand where a scalar belongs: coordinates, parameters and `let`s.
    scalars: Vec<String>,
    vectors: Vec<String>,
    coordinates: Vec<String>,
}

impl Writer {
    fn declaration(&mut self, name: &str) -> String {
        let mut text = format!("pub {name};\n");
        let count = 1 + self.random.below(4);
        text += &self.coordinates(count);
        let parameters: Vec<String> = (1..=3).map(|i| format!("p{i}")).collect();
        text += "parameters { ";
        for parameter in &parameters {
            text += &format!("{parameter} = {:.3}; ", self.random.between(0.3, 2.5));
        }
        text += "}\n";
        self.scalars.extend(parameters);
        self.scalars.push("t".into());
        for i in 0..self.random.below(4) {
            text += &format!("let s{i} = {};\n", self.scalar(3));
            self.scalars.push(format!("s{i}"));
        }
        for i in 0..1 + self.random.below(3) {
            text += &format!("let v{i} = {};\n", self.vector(2));
            self.vectors.push(format!("v{i}"));
        }
        if self.random.once_in(2) {
            text += &self.fragment();
        }
        text += "auxiliary { cut; } inputs { drive = sin(p1*t)/2; }\n";
        text += &self.bodies();
        text += &self.loads();
        let constraints = self.constraints();
        text += &constraints.0;
        text += &format!("events {{ crossing: {} = {}; }}\n", self.rate(2), self.scalar(1));
        text += &self.outputs(&constraints.1);
        text
    }

    fn coordinates(&mut self, count: usize) -> String {
        let text = match self.random.below(2) {
            0 => format!("coordinates {{ repeat i in 1..={count} {{ q_[i]; }} }}\n"),
            _ => (1..=count).map(|i| format!("coordinates {{ q_{i}; }}\n")).collect(),
        };
        self.coordinates = (1..=count).map(|i| format!("q_{i}")).collect();
        self.scalars.extend(self.coordinates.clone());
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
            self.random.between(0.5, 2.0),
            self.random.between(0.1, 0.4)
        );
        let arms = if self.random.once_in(2) {
            let base = self.vector(1);
            let size = self.random.below(2) + 1;
            self.named_arm("arm");
            format!("use Arm({base}, {size}) as arm;\n")
        } else {
            let (base, size) = (self.random.pick(&self.vectors).clone(), self.scalar(0));
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
        self.scalars.push(format!("{arm}_a"));
        self.coordinates.push(format!("{arm}_a"));
        self.vectors.push(format!("{arm}_tip"));
    }

    /// Every coordinate has a mass of its own, so that the mass matrix has full rank.
    fn bodies(&mut self) -> String {
        let mut text = String::from("bodies {\n");
        for (i, coordinate) in self.coordinates.clone().iter().enumerate() {
            let mass = self.random.between(0.5, 2.0);
            let cut = if i == 0 { " + cut" } else { "" };
            text += &format!("own{i}: mass {mass:.2} at [{coordinate}{cut}, {}], ", self.scalar(1));
            text += &format!("inertia 0.1, angle {coordinate};\n");
        }
        for i in 0..self.random.below(3) {
            let (mass, inertia) = (self.random.pick(&["p1", "p2*p3", "2"]), self.random.pick(&["p2", "0", "p1^2/12"]));
            let (at, angle) = (self.vector(2), self.scalar(2));
            text += &format!("body{i}: mass {mass} at {at} + [cut + q_1, 0], inertia {inertia}, angle {angle};\n");
        }
        text + "}\n"
    }

    fn loads(&mut self) -> String {
        let mut text = String::from("loads { gravity [0, -9.81]; force drive on q_1;\n");
        for _ in 0..self.random.below(3) {
            let (x, y, at) = (self.rate(2), self.scalar(2), self.vector(1));
            text += &format!("force [{x}, {y}] at {at};\n");
        }
        if self.random.once_in(2) {
            text += &format!("torque {} on own0;\n", self.rate(2));
        }
        for _ in 0..self.random.below(3) {
            text += &self.element();
        }
        text + "}\n"
    }

    /// Springs, dampers, potentials: a line.
    fn element(&mut self) -> String {
        let coordinate = self.random.pick(&self.coordinates).clone();
        match self.random.below(6) {
            0 => format!("spring p1, rest {} on {coordinate} + {};\n", self.scalar(0), self.scalar(2)),
            1 => format!("spring p2*stretch^3, rest 0.3 between {} and {coordinate};\n", self.scalar(1)),
            2 => format!(
                "spring p1, length 0.4 from {} to [9 + sin({coordinate}), 7 - {coordinate}^2];\n",
                self.vector(1)
            ),
            3 => format!("damper p3*rate*abs(rate) on {coordinate} - {};\n", self.scalar(2)),
            4 => format!("potential {coordinate}*({});\n", self.scalar(2)),
            _ => format!("dissipation p2/2*dot({coordinate}*({}))^2;\n", self.scalar(1)),
        }
    }

    /// The block, and the names of scalar constraints.
    fn constraints(&mut self) -> (String, Vec<String>) {
        let count = self.random.below(self.coordinates.len().min(3));
        let mut text = String::from("constraints {\n");
        for i in 0..count {
            // What a coordinate is equal to depends on others too, so that each constraint can be met.
            let coordinate = self.coordinates[i].clone();
            text += &format!("c{i}: {coordinate} + {}/4 = {}/3;\n", self.scalar(1), self.scalar(2));
        }
        // Held between speeds, where a coordinate is left.
        if count + 1 < self.coordinates.len() && self.random.once_in(3) {
            let (last, first) = (self.coordinates[self.coordinates.len() - 1].clone(), self.coordinates[0].clone());
            text += &format!("rolling: dot({last}) + {}*dot({first})/5 = {};\n", self.scalar(1), self.scalar(1));
        }
        (text + "}\n", (0..count).map(|i| format!("c{i}")).collect())
    }

    fn outputs(&mut self, constraints: &[String]) -> String {
        let mut text =
            format!("outputs {{ rate = {}; second = ddot({}); force = reaction(cut); ", self.rate(2), self.scalar(2));
        for constraint in constraints {
            text += &format!("r_{constraint} = reaction({constraint})*{}; ", self.scalar(0));
        }
        let count = self.coordinates.iter().filter(|name| name.starts_with("q_")).count();
        text += &format!("all = sum(i in 1..={count}, i*q_[i]^2);");
        text + "}\n"
    }

    /// A scalar expression of at most this depth, defined everywhere.
    fn scalar(&mut self, depth: usize) -> String {
        if depth == 0 {
            return match self.random.below(4) {
                0 => format!("{:.1}", self.random.below(30) as f64 / 10.0 + 0.1),
                _ => self.random.pick(&self.scalars).clone(),
            };
        }
        let mut next = || self.scalar(depth - 1);
        let (a, b) = (next(), next());
        match self.random.below(16) {
            0 | 1 => format!("({a} + {b})"),
            2 => format!("({a} - {b})"),
            3 | 4 => format!("{a}*({b})"),
            5 => format!("({a})/(1.5 + ({b})^2)"),
            6 => format!("sin({a})"),
            7 => format!("cos({a} + {b})"),
            8 => format!("tanh({a})"),
            9 => format!("sqrt(1 + ({a})^2)"),
            10 => format!("exp(-({a})^2)*({b})"),
            11 => format!("({a})^{}", 2 + self.random.below(2)),
            12 => format!("atan2({a}, 2 + sin({b}))"),
            13 => format!("-({a})*ln(2 + ({b})^2)"),
            14 => format!("norm({})", self.offset_vector(depth - 1)),
            _ => format!("inner({}, {})", self.vector(depth - 1), self.vector(depth - 1)),
        }
    }

    /// A scalar in which speeds may stand.
    fn rate(&mut self, depth: usize) -> String {
        let (a, b) = (self.scalar(depth), self.scalar(1));
        match self.random.below(3) {
            0 => a,
            1 => format!("dot({a})"),
            _ => format!("({a} - {}*dot({b}))", self.random.between(0.1, 0.9)),
        }
    }

    fn vector(&mut self, depth: usize) -> String {
        if depth == 0 && !self.vectors.is_empty() {
            return self.random.pick(&self.vectors).clone();
        }
        let depth = depth.saturating_sub(1);
        match self.random.below(4) {
            0 if !self.vectors.is_empty() => format!("({} + {})", self.vector(depth), self.vector(depth)),
            1 if !self.vectors.is_empty() => format!("({})*{}", self.scalar(depth), self.vector(depth)),
            _ => format!("[{}, {}]", self.scalar(depth), self.scalar(depth)),
        }
    }

    /// A vector that is nowhere zero.
    fn offset_vector(&mut self, depth: usize) -> String {
        format!("[2 + sin({}), {}]", self.scalar(depth), self.scalar(depth))
    }
}
