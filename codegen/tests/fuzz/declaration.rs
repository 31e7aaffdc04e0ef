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
        text += &self.tables();
        text += "auxiliary { cut; } inputs { drive = sin(p1*t)/2; }\n";
        text += &self.bodies();
        text += &self.loads();
        let constraints = self.constraints();
        text += &constraints.0;
        if self.random.once_in(3) {
            text += &self.joints();
        }
        text += &self.events(&constraints.2);
        text += &self.outputs(&constraints.1);
        text
    }

    /// Tables of every kind: smooth ones for positions, and others.
    fn tables(&mut self) -> String {
        let outside = |random: &mut Random| *random.pick(&["held", "continued"]);
        let (first, second, third) = (outside(&mut self.random), outside(&mut self.random), outside(&mut self.random));
        let ends = *self.random.pick(&["", ", natural", ", clamped"]);
        let close = self.random.between(-1.0, 1.0);
        let hills = format!("cubic, periodic {{ -1, {close:?}; {} {close:?}; }}", self.rows(-1.0, 5));
        let stairs = format!("cubic{ends}, {first} {{ {} }}", self.rows(-2.0, 7).trim_end_matches("5.5, "));
        let kinks = format!("linear, {second} {{ {} }}", self.rows(-1.5, 3).trim_end_matches("5.5, "));
        let bends = format!("monotone, {third} {{ {} }}", self.rows(-3.0, 9).trim_end_matches("5.5, "));
        format!("tables {{ hills = {hills} stairs = {stairs} kinks = {kinks} bends = {bends} }}\n")
    }

    /// Rows beyond an argument, and an argument beyond them.
    fn rows(&mut self, after: f64, count: usize) -> String {
        let step = (5.0 - after) / count as f64;
        let mut rows = String::new();
        for i in 1..=count {
            let x = after + step * (i as f64 - self.random.between(0.1, 0.9));
            rows += &format!("{x:.3}, {:.3}; ", self.random.between(-1.0, 1.0));
        }
        rows + "5.5, "
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
            1 => format!(
                "spring p2*stretch^3, rest 0.3 between {} and 3*{coordinate} + {coordinate}^3/9;\n",
                self.scalar(1)
            ),
            2 => format!(
                "spring p1, length 0.4 from {} to [9 + sin({coordinate}), 7 - {coordinate}^2];\n",
                self.vector(1)
            ),
            3 => format!("damper p3*rate*abs(rate) on {coordinate} - {};\n", self.scalar(2)),
            4 => format!("potential {coordinate}*({});\n", self.scalar(2)),
            _ => format!("dissipation p2/2*dot({coordinate}*({}))^2;\n", self.scalar(1)),
        }
    }

    /// The block, the names of scalar constraints, and those of them that events switch.
    fn constraints(&mut self) -> (String, Vec<String>, Vec<String>) {
        let count = self.random.below(self.coordinates.len().min(3));
        let (mut text, mut switched) = (String::from("constraints {\n"), vec![]);
        for i in 0..count {
            // What a coordinate is equal to depends on others too, so that each constraint can be met.
            let coordinate = self.coordinates[i].clone();
            let initially = *self.random.pick(&["", "", " initially active", " initially released"]);
            if !initially.is_empty() {
                switched.push(format!("c{i}"));
            }
            text += &format!("c{i}: {coordinate} + {}/4 = {}/3{initially};\n", self.scalar(1), self.scalar(2));
        }
        // Held between speeds, where a coordinate is left.
        if count + 1 < self.coordinates.len() && self.random.once_in(3) {
            let (last, first) = (self.coordinates[self.coordinates.len() - 1].clone(), self.coordinates[0].clone());
            text += &format!("rolling: dot({last}) + {}*dot({first})/5 = {};\n", self.scalar(1), self.scalar(1));
        }
        (text + "}\n", (0..count).map(|i| format!("c{i}")).collect(), switched)
    }

    /// A rod that hangs on a pin, perhaps turned by a gear: coordinates of its own.
    fn joints(&mut self) -> String {
        let at = self.vector(2);
        let gear = *self.random.pick(&["", "mesh: gear own0 radius 0.4 to rod radius 0.7;"]);
        format!(
            "bodies {{ rod: free, mass 1.3, inertia 0.2; }}
            joints {{ pivot: pin on(rod, [0.4, -0.1]) to {at}; {gear} }}
            loads {{ force [0, 0.3] at on(rod, [-0.4, 0]); }}\n"
        )
    }

    /// Events, and what happens at them.
    fn events(&mut self, switched: &[String]) -> String {
        let mut text = format!("events {{ crossing: {} + q_1 = {};\n", self.rate(2), self.scalar(1));
        let (value, speed) = (self.scalar(2), self.rate(1));
        text += &format!(
            "jump: q_1 + {} = 0.3 rising {{ set q_1 = {value}; set dot(q_1) = {speed}; set p2 = p2/2; }}\n",
            self.rate(1)
        );
        for name in switched {
            let (condition, restitution) = (self.rate(1), self.scalar(1));
            text += &format!("on_{name}: {condition} = t falling {{ activate {name}; }}\n");
            text += &format!(
                "hit_{name}: {condition} = 0.1*t rising {{ impact {name} restitution tanh({restitution})^2; release {name}; }}\n"
            );
        }
        text + "}\n"
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
        match self.random.below(21) {
            0 | 1 => format!("({a} + {b})"),
            2 => format!("({a} - {b})"),
            3 | 4 => format!("{a}*({b})"),
            5 => format!("({a})/(1.5 + ({b})^2)"),
            6 => format!("sin({a})"),
            7 => format!("cos({a} + {b})"),
            // Kernels have 1 - tanh^2 as its slope, of which little is left where tanh is near 1.
            8 => format!("tanh(({a})/4)"),
            9 => format!("sqrt(1 + ({a})^2)"),
            10 => format!("exp(-({a})^2)*({b})"),
            11 => format!("({a})^{}", 2 + self.random.below(2)),
            12 => format!("atan2({a}, 2 + sin({b}))"),
            13 => format!("-({a})*ln(2 + ({b})^2)"),
            14 => format!("norm({})", self.offset_vector(depth - 1)),
            16 => format!("hills({a})"),
            17 => format!("stairs({a} - {b})"),
            18 => format!("max({a}, {b}, 0.3)"),
            19 => format!("abs({a})*min({b}, 1)"),
            20 => format!("(if {a} > {b} then {a}*({b}) else {b}^2)"),
            _ => format!("inner({}, {})", self.vector(depth - 1), self.vector(depth - 1)),
        }
    }

    /// A scalar in which speeds may stand.
    fn rate(&mut self, depth: usize) -> String {
        let (a, b) = (self.scalar(depth), self.scalar(1));
        match self.random.below(5) {
            0 => a,
            3 => format!("kinks({a})*({b})"),
            4 => format!("bends(dot({a}) + {b})"),
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
