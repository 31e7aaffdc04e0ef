//! Parts of declarations that are the same in the plane and in space.

use crate::expression::Known;

/// A block of constraints.
pub(crate) struct Constraints {
    pub(crate) block: String,
    /// The scalar ones between positions.
    pub(crate) names: Vec<String>,
    /// Those of them that events switch.
    pub(crate) switched: Vec<String>,
}

impl Known {
    /// Springs, dampers, potentials: a line.
    pub(crate) fn element(&mut self) -> String {
        let coordinate = self.random.pick(&self.coordinates).clone();
        match self.random.below(6) {
            0 => format!("spring p1, rest {} on {coordinate} + {};\n", self.scalar(0), self.scalar(2)),
            1 => format!(
                "spring p2*stretch^3, rest 0.3 between {} and 3*{coordinate} + {coordinate}^3/9;\n",
                self.scalar(1)
            ),
            2 => format!(
                "spring p1, length 0.4 from {} to [9 + sin({coordinate}), 7 - {coordinate}^2{}];\n",
                self.vector(1),
                self.third(", 8")
            ),
            3 => format!("damper p3*rate*abs(rate) on {coordinate} - {};\n", self.scalar(2)),
            4 => format!("potential {coordinate}*({});\n", self.scalar(2)),
            _ => format!("dissipation p2/2*dot({coordinate}*({}))^2;\n", self.scalar(1)),
        }
    }

    pub(crate) fn constraints(&mut self) -> Constraints {
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
        Constraints { block: text + "}\n", names: (0..count).map(|i| format!("c{i}")).collect(), switched }
    }

    /// Events, and what happens at them.
    pub(crate) fn events(&mut self, switched: &[String]) -> String {
        // The coefficient is one that no random expression cancels: a condition that never changes is a mistake.
        let mut text = format!("events {{ crossing: {} + 2.7*q_1 = {};\n", self.rate(2), self.scalar(1));
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
}
