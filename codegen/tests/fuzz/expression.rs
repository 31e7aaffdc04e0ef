//! Random expressions of what has been declared.

use crate::random::Random;

/// What can stand in expressions.
pub(crate) struct Known {
    pub(crate) random: Random,
    /// Components of vectors.
    dimension: usize,
    /// Coordinates, parameters and `let`s.
    pub(crate) scalars: Vec<String>,
    pub(crate) vectors: Vec<String>,
    pub(crate) rotations: Vec<String>,
    pub(crate) coordinates: Vec<String>,
}

impl Known {
    pub(crate) fn new(seed: usize, dimension: usize) -> Known {
        let (scalars, vectors, rotations, coordinates) = (vec![], vec![], vec![], vec![]);
        Known { random: Random::new(seed), dimension, scalars, vectors, rotations, coordinates }
    }

    /// Three parameters, with which time is known too.
    pub(crate) fn parameters(&mut self) -> String {
        let parameters: Vec<String> = (1..=3).map(|i| format!("p{i}")).collect();
        let default = |name| format!("{name} = {:.3}; ", self.random.between(0.3, 2.5));
        let block = format!("parameters {{ {}}}\n", parameters.iter().map(default).collect::<String>());
        self.scalars.extend(parameters);
        self.scalars.push("t".into());
        block
    }

    /// So many `let`s of scalars.
    pub(crate) fn named_scalars(&mut self, count: usize) -> String {
        let mut text = String::new();
        for i in 0..count {
            text += &format!("let s{i} = {};\n", self.scalar(3));
            self.scalars.push(format!("s{i}"));
        }
        text
    }

    /// So many `let`s of vectors.
    pub(crate) fn named_vectors(&mut self, count: usize) -> String {
        let mut text = String::new();
        for i in 0..count {
            text += &format!("let v{i} = {};\n", self.vector(2));
            self.vectors.push(format!("v{i}"));
        }
        text
    }

    /// So many `let`s of rotations.
    pub(crate) fn named_rotations(&mut self, count: usize) -> String {
        let mut text = String::new();
        for i in 0..count {
            text += &format!("let R{i} = {};\n", self.rotation());
            self.rotations.push(format!("R{i}"));
        }
        text
    }

    /// A scalar expression of at most this depth, defined everywhere.
    pub(crate) fn scalar(&mut self, depth: usize) -> String {
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
    pub(crate) fn rate(&mut self, depth: usize) -> String {
        let (a, b) = (self.scalar(depth), self.scalar(1));
        match self.random.below(5) {
            0 => a,
            3 => format!("kinks({a})*({b})"),
            4 => format!("bends(dot({a}) + {b})"),
            1 => format!("dot({a})"),
            _ => format!("({a} - {}*dot({b}))", self.random.between(0.1, 0.9)),
        }
    }

    /// In space none has a frame of its own, and all fit everywhere.
    pub(crate) fn vector(&mut self, depth: usize) -> String {
        if depth == 0 && !self.vectors.is_empty() {
            return self.random.pick(&self.vectors).clone();
        }
        let depth = depth.saturating_sub(1);
        let forms = if self.dimension == 3 { 6 } else { 4 };
        match self.random.below(forms) {
            0 if !self.vectors.is_empty() => format!("({} + {})", self.vector(depth), self.vector(depth)),
            1 if !self.vectors.is_empty() => format!("(({})*{})", self.scalar(depth), self.vector(depth)),
            4 if !self.vectors.is_empty() => format!("cross({}, [0.3, {}, 1])", self.vector(depth), self.scalar(depth)),
            5 if !self.rotations.is_empty() => {
                format!("({}*{})", self.random.pick(&self.rotations).clone(), self.vector(depth))
            }
            _ => format!("[{}, {}{}]", self.scalar(depth), self.scalar(depth), self.third(", 0.6")),
        }
    }

    /// A vector that is nowhere zero.
    fn offset_vector(&mut self, depth: usize) -> String {
        format!("[2 + sin({}), {}{}]", self.scalar(depth), self.scalar(depth), self.third(", p2"))
    }

    /// The third component, where there is one.
    pub(crate) fn third(&self, component: &'static str) -> &'static str {
        if self.dimension == 3 { component } else { "" }
    }

    /// Up to three turns, one after the other.
    fn rotation(&mut self) -> String {
        let turns: Vec<String> = (0..1 + self.random.below(3)).map(|_| self.turn()).collect();
        turns.join("*")
    }

    fn turn(&mut self) -> String {
        const SEQUENCES: [&str; 12] =
            ["xyx", "xyz", "xzx", "xzy", "yxy", "yxz", "yzx", "yzy", "zxy", "zxz", "zyx", "zyz"];
        let angles = [(); 3].map(|()| self.scalar(1));
        let [a, b, c] = &angles;
        match self.random.below(8) {
            0 | 1 => format!("rotation({}, {a})", self.random.pick(&["x", "y", "z"])),
            2 => format!("rotation([3/5, 0, -4/5], {a})"),
            3 => format!("rotation([sin({a}), 0, cos({a})], {b})"),
            4 => format!("euler({}, {a}, {b}, {c})", self.random.pick(&SEQUENCES)),
            5 => format!("axes([cos({a}), 0, -sin({a})], y, [sin({a}), 0, cos({a})])"),
            6 => format!("quaternion(1.5, {a}, 0.3, {b})"),
            _ if self.rotations.is_empty() => format!("transpose(rotation(y, {a})*rotation(x, {b}))"),
            _ => format!("transpose({})", self.random.pick(&self.rotations)),
        }
    }
}
