//! Linkages of space as declarations.

use crate::declare::Declared;
use crate::topology::SpatialForm::{Attitude, Free, Joints, Turns};
use crate::topology::{Held, Spatial, SpatialForm};

/// A linkage in all of its forms.
pub(crate) fn declarations(linkage: &Spatial) -> Vec<Declared> {
    linkage.forms.iter().map(|form| Writer { linkage, form: *form }.declared()).collect()
}

struct Writer<'l> {
    linkage: &'l Spatial,
    form: SpatialForm,
}

impl Writer<'_> {
    fn declared(&self) -> Declared {
        let name = self.linkage.name;
        let type_name = format!("{name}{:?}", self.form);
        let text = [
            format!("/// {name}, by {:?}.\npub(crate) {type_name};\n", self.form),
            self.parameters(),
            self.coordinates(),
            self.bodies(),
            self.joints(),
            self.loads(),
            self.initial(),
            self.outputs(),
            "kernels { }\n".to_owned(),
        ];
        Declared { type_name, text: text.concat() }
    }

    fn each(&self, line: impl Fn(usize) -> String) -> String {
        (0..self.linkage.bodies()).map(line).collect()
    }

    /// Of each body its mass, moments of inertia and centre of mass, its length and twist, and where it starts; `t_j` is the
    /// turn of joint j at the start. The ground has a length and a twist too.
    fn parameters(&self) -> String {
        let body = |b: usize| {
            let inertia: String = (1..=3).map(|i| format!("J{i}_{b} [kg*m^2] = 0.1; ")).collect();
            let start: String = (0..4).map(|i| format!("q{i}_{b} = {}; ", u8::from(i == 0))).collect();
            let centre = format!("cx_{b} [m] = 0.5; cy_{b} [m] = 0; cz_{b} [m] = 0;");
            format!(
                "m_{b} [kg] = 1; {inertia}{centre} l_{b} [m] = 1; tw_{b} [rad] = 1; {start}X_{b} [m] = 0; Y_{b} [m] = 0; Z_{b} [m] = 0;\n"
            )
        };
        let joints: String =
            (0..self.linkage.joints.len()).map(|j| format!("t_{j} [rad] = 0; u_{j} [rad] = 0; ")).collect();
        let ground = "lx [m] = 1; ly [m] = 0; lz [m] = 0; tw [rad] = 1;";
        let rates = "w [rad/s] = 1; w1 [rad/s] = 1; w2 [rad/s] = 0.5; w3 [rad/s] = -0.7;";
        let between: String = (0..4).map(|i| format!("p{i} = {}; ", u8::from(i == 0))).collect();
        let loads = "gx [m/s^2] = 0; gy [m/s^2] = 0; gz [m/s^2] = 0; T [N*m] = 0; kd [N*m*s] = 0;";
        format!("parameters {{\n{}{joints}\n{ground} {between} {rates} {loads}\n}}\n", self.each(body))
    }

    /// The turns at a joint: axis and coordinate of each.
    fn turns(&self, j: usize) -> Vec<(char, String)> {
        match self.linkage.joints[j] {
            Held::Universal => vec![('z', format!("a_{j}")), ('y', format!("b_{j}"))],
            _ => vec![('z', format!("a_{j}"))],
        }
    }

    fn coordinates(&self) -> String {
        match self.form {
            Turns => {
                let turns = self.linkage.placed().into_iter().flat_map(|[_, j]| self.turns(j));
                let names: String = turns.map(|(_, name)| format!("{name} [rad]; ")).collect();
                format!("coordinates {{ {names}}}\n")
            }
            Attitude => "coordinates { q0; q1; q2; q3; }\nlet R_0 = quaternion(q0, q1, q2, q3);\n".to_owned(),
            Joints | Free => String::new(),
        }
    }

    /// A place in a body's frame, whose origin is its first joint, as seen from its centre of mass.
    fn from_centre(b: usize, place: [&str; 3]) -> String {
        let [x, y, z] = place;
        format!("[{x} - cx_{b}, {y} - cy_{b}, {z} - cz_{b}]")
    }

    /// Where joint j is on the body before it or after it.
    fn place(&self, j: usize, body: Option<usize>) -> String {
        match body {
            None if j == 0 => "[0, 0, 0]".to_owned(),
            None => "[lx, ly, lz]".to_owned(),
            Some(b) if b == j => Self::from_centre(b, ["0", "0", "0"]),
            Some(b) => Self::from_centre(b, [&format!("l_{b}"), "0", "0"]),
        }
    }

    /// The axis of joint j in the frame of the body before it or after it. A body that is placed from its far end has its
    /// hinge there along z too.
    fn axis(&self, j: usize, body: Option<usize>) -> String {
        let twisted = |angle: &str| format!("[0, -sin({angle}), cos({angle})]");
        let is_universal = self.linkage.joints[j] == Held::Universal;
        match body {
            None if j == 0 => "[0, 0, 1]".to_owned(),
            None => "[0, sin(tw), cos(tw)]".to_owned(),
            Some(b) if b == j => if is_universal { "[0, 1, 0]" } else { "[0, 0, 1]" }.to_owned(),
            Some(b) => twisted(&format!("tw_{b}")),
        }
    }

    fn bodies(&self) -> String {
        let inertia = |b: usize| format!("inertia [J1_{b}, J2_{b}, J3_{b}]");
        match self.form {
            Joints => self.each(|b| format!("bodies {{ b_{b}: mass m_{b}, {}; }}\n", inertia(b))),
            Free => self.each(|b| format!("bodies {{ b_{b}: free, mass m_{b}, {}; }}\n", inertia(b))),
            Attitude => {
                let arm = Self::from_centre(0, ["0", "0", "0"]);
                format!("bodies {{ b_0: mass m_0 at -(R_0*{arm}), {}, attitude R_0; }}\n", inertia(0))
            }
            Turns => self.linkage.placed().into_iter().map(|[b, j]| self.turned_body(b, j)).collect(),
        }
    }

    fn turned_body(&self, b: usize, j: usize) -> String {
        let turns: Vec<String> = self.turns(j).iter().map(|(axis, name)| format!("rotation({axis}, {name})")).collect();
        let mut turns = turns.join("*");
        let (frame, point) = match self.linkage.joined(j).into_iter().flatten().find(|other| *other != b) {
            None if j == 0 => (String::new(), "[0, 0, 0]".to_owned()),
            // From the far end of the ground: its axis, the turn, and back by the body's own twist.
            None => {
                turns += &format!("*rotation(x, -tw_{b})");
                ("rotation(x, -tw)*".to_owned(), "[lx, ly, lz]".to_owned())
            }
            Some(a) => (format!("R_{a}*rotation(x, tw_{a})*"), format!("G_{a} + R_{a}*{}", self.place(j, Some(a)))),
        };
        let arm = self.place(j, Some(b));
        format!(
            "let R_{b} = {frame}{turns};\nlet G_{b} = {point} - R_{b}*{arm};\n\
             bodies {{ b_{b}: mass m_{b} at G_{b}, inertia [J1_{b}, J2_{b}, J3_{b}], attitude R_{b}; }}\n"
        )
    }

    /// The joints that close the loop in this form, or all of them.
    fn joints(&self) -> String {
        let count = self.linkage.joints.len();
        let placing: Vec<usize> = self.linkage.placed().into_iter().map(|[_, j]| j).collect();
        let listed: Vec<usize> = match self.form {
            Attitude => return "constraints { unit: q0^2 + q1^2 + q2^2 + q3^2 = 1; }\n".to_owned(),
            Turns => (0..count).filter(|j| !placing.contains(j)).collect(),
            Free => (0..count).collect(),
            // Both ends first, from the ground inwards, and what is cut last.
            Joints if self.linkage.is_top() => vec![0],
            Joints => {
                let cut = self.linkage.cut;
                (0..cut).chain((cut + 1..count).rev()).chain([cut]).collect()
            }
        };
        let joint = |j: usize| {
            let side = |body: Option<usize>| {
                let name = body.map_or("ground".to_owned(), |b| format!("b_{b}"));
                let axis = match self.linkage.joints[j] {
                    Held::Ball => String::new(),
                    _ => format!(" axis {}", self.axis(j, body)),
                };
                format!("{name} at {}{axis}", self.place(j, body))
            };
            let kind = match self.linkage.joints[j] {
                Held::Hinge => "revolute",
                Held::Universal => "universal",
                Held::Ball => "ball",
            };
            let [first, second] = self.linkage.joined(j);
            format!("j_{j}: {kind} {} to {};\n", side(first), side(second))
        };
        format!("joints {{\n{}}}\n", listed.into_iter().map(joint).collect::<String>())
    }

    fn loads(&self) -> String {
        "loads { gravity [gx, gy, gz]; torque [0, 0, T - kd*omega(b_0).z] on b_0; }\n".to_owned()
    }

    fn initial(&self) -> String {
        let is_top = self.linkage.is_top();
        let given = |name: &str, values: [&str; 4]| -> String {
            (0..4).map(|i| format!("{name}q{i} = {}; ", values[i])).collect()
        };
        let unit = ["1", "0", "0", "0"];
        // At the world's axes.
        let own = |name: &str| {
            let rates = ["0", "w1/2", "w2/2", "w3/2"];
            let rates: String = (0..4).map(|i| format!("dot({name}q{i}) = {}; ", rates[i])).collect();
            given(name, unit) + &rates
        };
        let lines = match self.form {
            Attitude => own(""),
            Joints if is_top => own("j_0_"),
            Free if is_top => own("b_0_") + "guess b_0_x = X_0; guess b_0_y = Y_0; guess b_0_z = Z_0;",
            Turns => {
                // Turns are those of the body after a joint against that before it.
                let guess = |[b, j]: [usize; 2]| match self.linkage.joints[j] {
                    Held::Universal => format!("guess a_{j} = t_{j}; guess b_{j} = u_{j};"),
                    _ if j == 0 => "a_0 = t_0; dot(a_0) = w;".to_owned(),
                    _ if b < j => format!("guess a_{j} = -t_{j};"),
                    _ => format!("guess a_{j} = t_{j};"),
                };
                self.linkage.placed().into_iter().map(guess).collect()
            }
            Joints => {
                let guess = |j: usize| match self.linkage.joints[j] {
                    _ if j == self.linkage.cut => String::new(),
                    // Of the body after it against that before it; which is first is a matter of words.
                    Held::Ball => (0..4).map(|i| format!("guess j_{j}_q{i} = p{i}; ")).collect(),
                    _ if j == 0 => "j_0 = t_0; dot(j_0) = w; ".to_owned(),
                    _ => format!("guess j_{j} = t_{j}; "),
                };
                (0..self.linkage.joints.len()).map(guess).collect()
            }
            Free => self.each(|b| {
                let guess = if b == 0 { "" } else { "guess " };
                let places = format!("guess b_{b}_x = X_{b}; guess b_{b}_y = Y_{b}; guess b_{b}_z = Z_{b}; ");
                let turned: String = (0..4).map(|i| format!("{guess}b_{b}_q{i} = q{i}_{b}; ")).collect();
                // About z, as the first hinge of the ground is.
                let rates = ["-w*q3_0/2", "-w*q2_0/2", "w*q1_0/2", "w*q0_0/2"];
                let rates: String = (0..4).map(|i| format!("dot(b_0_q{i}) = {}; ", rates[i])).collect();
                places + &turned + if b == 0 { &rates } else { "" } + "\n"
            }),
        };
        format!("initial {{ {lines} }}\n")
    }

    fn outputs(&self) -> String {
        let body = |b: usize| {
            let mut text =
                format!("let c_{b} = on(b_{b}, [0, 0, 0]);\nlet d_{b} = attitude(b_{b})*[1, 0, 0];\noutputs {{\n");
            for x in ["x", "y", "z"] {
                text += &format!(
                    "{x}_{b} [m] = c_{b}.{x}; v{x}_{b} [m/s] = dot(c_{b}.{x}); a{x}_{b} [m/s^2] = ddot(c_{b}.{x}); "
                );
                text += &format!(
                    "d{x}_{b} = d_{b}.{x}; w{x}_{b} [rad/s] = omega(b_{b}).{x}; e{x}_{b} [rad/s^2] = dot(omega(b_{b}).{x});\n"
                );
            }
            text + "}\n"
        };
        // A loop with a ball and a universal joint determines all of its forces; in these forms the ball is a constraint.
        let is_determined = self.linkage.joints.contains(&Held::Universal) && self.form != Joints;
        let force = match is_determined {
            true => "outputs { fx_2 [N] = reaction(j_2).x; fy_2 [N] = reaction(j_2).y; fz_2 [N] = reaction(j_2).z; }\n",
            false => "",
        };
        self.each(body) + force
    }
}
