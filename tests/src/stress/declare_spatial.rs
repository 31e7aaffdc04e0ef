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

    fn parameters(&self) -> String {
        let body = |b: usize| {
            let inertia: String = (1..=3).map(|i| format!("J{i}_{b} [kg*m^2] = 0.1; ")).collect();
            format!("m_{b} [kg] = 1; {inertia}X_{b} [m] = 0; Y_{b} [m] = 0; Z_{b} [m] = 0;\n")
        };
        let joint = |j: usize| {
            let place = format!("x_{j} [m] = 0; y_{j} [m] = 0; z_{j} [m] = 1;");
            format!("{place} nx_{j} = 1; ny_{j} = 0; nz_{j} = 0; mx_{j} = 0; my_{j} = 1; mz_{j} = 0;\n")
        };
        let joints: String = (0..self.linkage.joints.len()).map(joint).collect();
        let rates = "w [rad/s] = 1; w1 [rad/s] = 1; w2 [rad/s] = 0.5; w3 [rad/s] = -0.7;";
        format!("parameters {{\n{}{joints}{rates} g [m/s^2] = 0; T [N*m] = 0; kd [N*m*s] = 0;\n}}\n", self.each(body))
    }

    /// The turns by which a body is placed in the form `Turns`: each with its joint, axis and coordinate.
    fn turns(&self, b: usize) -> Vec<(usize, char, String)> {
        match self.linkage.joints[b] {
            Held::Universal => vec![(b, 'n', format!("a_{b}")), (b, 'm', format!("b_{b}"))],
            _ => vec![(b, 'n', format!("a_{b}"))],
        }
    }

    /// The bodies in the order in which they are placed by `Turns`, each with the body before it and the joint between
    /// them. A ball is no turn: what follows it is placed from the other end.
    fn placed(&self) -> Vec<(usize, Option<usize>, usize)> {
        let count = self.linkage.bodies();
        let ball = self.linkage.joints.iter().position(|held| *held == Held::Ball).unwrap_or(count);
        let ahead = (0..count.min(ball)).map(|b| (b, b.checked_sub(1), b));
        let back = (count.min(ball)..count).rev().map(|b| (b, (b + 1 < count).then_some(b + 1), b + 1));
        ahead.chain(back).collect()
    }

    fn coordinates(&self) -> String {
        match self.form {
            Turns => {
                let turns = self.placed().into_iter().flat_map(|(.., j)| self.turns(j));
                let names: String = turns.map(|(.., name)| format!("{name} [rad]; ")).collect();
                format!("coordinates {{ {names}}}\n")
            }
            Attitude => "coordinates { q0; q1; q2; q3; }\nlet R_0 = quaternion(q0, q1, q2, q3);\n".to_owned(),
            Joints | Free => String::new(),
        }
    }

    fn place(&self, j: usize) -> String {
        format!("[x_{j}, y_{j}, z_{j}]")
    }

    fn axis(&self, j: usize, which: char) -> String {
        format!("[{which}x_{j}, {which}y_{j}, {which}z_{j}]")
    }

    /// Where joint j is on a body, in the body's frame.
    fn on_body(&self, j: usize, b: usize) -> String {
        format!("[x_{j} - X_{b}, y_{j} - Y_{b}, z_{j} - Z_{b}]")
    }

    fn bodies(&self) -> String {
        let inertia = |b: usize| format!("inertia [J1_{b}, J2_{b}, J3_{b}]");
        match self.form {
            Joints => self.each(|b| format!("bodies {{ b_{b}: mass m_{b}, {}; }}\n", inertia(b))),
            Free => self.each(|b| format!("bodies {{ b_{b}: free, mass m_{b}, {}; }}\n", inertia(b))),
            Attitude => format!(
                "bodies {{ b_0: mass m_0 at {} - R_0*{}, {}, attitude R_0; }}\n",
                self.place(0),
                self.on_body(0, 0),
                inertia(0)
            ),
            Turns => {
                let body = |(b, before, j): (usize, Option<usize>, usize)| {
                    let turn =
                        |(j, which, name): (usize, char, String)| format!("rotation({}, {name})", self.axis(j, which));
                    let turns: Vec<String> = self.turns(j).into_iter().map(turn).collect();
                    let (frame, point) = match before {
                        None => (String::new(), self.place(j)),
                        Some(a) => (format!("R_{a}*"), format!("G_{a} + R_{a}*{}", self.on_body(j, a))),
                    };
                    format!(
                        "let R_{b} = {frame}{};\nlet G_{b} = {point} - R_{b}*{};\nbodies {{ b_{b}: mass m_{b} at G_{b}, {}, attitude R_{b}; }}\n",
                        turns.join("*"),
                        self.on_body(j, b),
                        inertia(b)
                    )
                };
                self.placed().into_iter().map(body).collect()
            }
        }
    }

    /// The joints that close the loop in this form, or all of them.
    fn joints(&self) -> String {
        let count = self.linkage.joints.len();
        let placing: Vec<usize> = self.placed().into_iter().map(|(.., j)| j).collect();
        let listed: Vec<usize> = match self.form {
            Attitude => return "constraints { unit: q0^2 + q1^2 + q2^2 + q3^2 = 1; }\n".to_owned(),
            Turns => (0..count).filter(|j| !placing.contains(j)).collect(),
            Free => (0..count).collect(),
            // Both ends first, from the ground inwards, and what is cut last.
            Joints if count == 1 => vec![0],
            Joints => {
                let cut = self.linkage.cut;
                (0..cut).chain((cut + 1..count).rev()).chain([cut]).collect()
            }
        };
        let joint = |j: usize| {
            let [first, second] = self.linkage.joined(j);
            let side = |body: Option<usize>| match body {
                None => format!("ground at {}", self.place(j)),
                Some(b) => format!("b_{b} at {}", self.on_body(j, b)),
            };
            let (kind, axes) = match self.linkage.joints[j] {
                Held::Hinge => {
                    ("revolute", [format!(" axis {}", self.axis(j, 'n')), format!(" axis {}", self.axis(j, 'n'))])
                }
                Held::Universal => {
                    ("universal", [format!(" axis {}", self.axis(j, 'n')), format!(" axis {}", self.axis(j, 'm'))])
                }
                Held::Ball => ("ball", [String::new(), String::new()]),
            };
            format!("j_{j}: {kind} {}{} to {}{};\n", side(first), axes[0], side(second), axes[1])
        };
        format!("joints {{\n{}}}\n", listed.into_iter().map(joint).collect::<String>())
    }

    fn loads(&self) -> String {
        let axis = self.axis(0, 'n');
        format!("loads {{ gravity [0, 0, -g]; torque (T - kd*inner(omega(b_0), {axis}))*{axis} on b_0; }}\n")
    }

    fn initial(&self) -> String {
        let is_top = self.linkage.joints.len() == 1;
        let quaternion = |name: &str, guess: &str, rates: [&str; 3]| {
            let rate = |i: usize| format!("dot({name}q{i}) = {}/2; ", rates[i - 1]);
            let values =
                format!("{guess}{name}q0 = 1; {guess}{name}q1 = 0; {guess}{name}q2 = 0; {guess}{name}q3 = 0; ");
            let given = if rates[0].is_empty() { String::new() } else { (1..=3).map(rate).collect() };
            values + &given
        };
        let own = ["w1", "w2", "w3"];
        let lines = match self.form {
            Turns => "a_0 = 0; dot(a_0) = w;".to_owned(),
            Attitude => quaternion("", "", own) + "dot(q0) = 0;",
            Joints if is_top => quaternion("j_0_", "", own) + "dot(j_0_q0) = 0;",
            // Joints that are balls as coordinates start unturned too.
            Joints => {
                let ball = |j: &usize| self.linkage.joints[*j] == Held::Ball && *j != self.linkage.cut;
                let balls = (0..self.linkage.joints.len()).filter(ball);
                let start: String = balls.map(|j| quaternion(&format!("j_{j}_"), "guess ", [""; 3])).collect();
                format!("j_0 = 0; dot(j_0) = w; {start}")
            }
            Free => self.each(|b| {
                let places = format!("guess b_{b}_x = X_{b}; guess b_{b}_y = Y_{b}; guess b_{b}_z = Z_{b}; ");
                let name = format!("b_{b}_");
                let about_axis = ["w*nx_0", "w*ny_0", "w*nz_0"];
                let turned = match b {
                    0 if is_top => quaternion(&name, "", own) + &format!("dot({name}q0) = 0;"),
                    0 => quaternion(&name, "", about_axis) + &format!("dot({name}q0) = 0;"),
                    _ => quaternion(&name, "guess ", [""; 3]),
                };
                format!("{places}{turned}\n")
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
