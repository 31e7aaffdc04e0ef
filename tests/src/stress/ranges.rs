//! What errors of a column are a part of.

/// From the least to the greatest value of a column. Speeds, accelerations and forces count from zero: where they are constant
/// they have no range, and errors of a method are a part of their values.
pub(crate) struct Range {
    natural: f64,
    least: f64,
    greatest: f64,
}

impl Range {
    /// That of a column of this name with these values, for a linkage of this size, mass and speed.
    pub(crate) fn of(name: &str, scales: [f64; 3], column: &[f64]) -> Range {
        let mut range = Range::empty(name, scales);
        column.iter().for_each(|value| range.take(*value));
        range
    }

    fn empty(name: &str, [size, mass, speed]: [f64; 3]) -> Range {
        let zero = |natural: f64| Range { natural, least: 0.0, greatest: 0.0 };
        let open = |natural: f64| Range { natural, least: f64::INFINITY, greatest: f64::NEG_INFINITY };
        match name.trim_start_matches("extreme_").split('_').next().unwrap_or_default() {
            "x" | "y" | "z" => open(size),
            "angle" | "dx" | "dy" | "dz" => open(1.0),
            "vx" | "vy" | "vz" => zero(size * speed),
            "ax" | "ay" | "az" => zero(size * speed * speed),
            "w" | "wx" | "wy" | "wz" => zero(speed),
            "e" | "ex" | "ey" | "ez" => zero(speed * speed),
            // Forces.
            _ => zero(mass * size * speed * speed),
        }
    }

    /// Takes in a value.
    pub(crate) fn take(&mut self, value: f64) {
        self.least = self.least.min(value);
        self.greatest = self.greatest.max(value);
    }

    /// Its size, at least this part of the natural one.
    pub(crate) fn size(&self, part: f64) -> f64 {
        (self.greatest - self.least).max(part * self.natural)
    }
}
