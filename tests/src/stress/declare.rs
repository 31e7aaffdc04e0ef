//! Linkages as declarations: one description of bodies and joints is written out in several forms, so that these cannot
//! differ by a slip. This is part of the build script.
//!
//! All sizes are parameters, also where the joints are on each body.

use crate::topology::Body::{Bar, Piston, Plate};
use crate::topology::Form::{Absolute, Free, Joints, Quaternions, Reduced, Relative};
use crate::topology::{Form, Joint, Planar};

/// A declaration in one form.
pub(crate) struct Declared {
    /// Of the mechanism.
    pub(crate) type_name: String,
    /// What stands in `mechanism! { .. }`.
    pub(crate) text: String,
}

/// A linkage in all of its forms.
pub(crate) fn declarations(linkage: &Planar) -> Vec<Declared> {
    linkage.forms.iter().map(|form| Writer { linkage, form: *form }.declared()).collect()
}

struct Writer<'l> {
    linkage: &'l Planar,
    form: Form,
}

impl Writer<'_> {
    fn declared(&self) -> Declared {
        let name = self.linkage.name;
        let type_name = format!("{name}{:?}", self.form);
        let blocks = [
            self.parameters(),
            self.coordinates(),
            self.bodies(),
            self.joints(),
            self.loads(),
            self.initial(),
            self.outputs(),
            // Derivatives of the motion are not asked for here.
            "kernels { }\n".to_owned(),
        ];
        let text = format!("/// {name}, by {:?}.\npub(crate) {type_name};\n{}", self.form, blocks.concat());
        Declared { type_name, text }
    }

    fn each(&self, line: impl Fn(usize) -> String) -> String {
        (0..self.linkage.bodies.len()).map(line).collect()
    }

    fn is_spatial(&self) -> bool {
        matches!(self.form, Joints | Quaternions)
    }

    /// The body that placed another, with the joint between them.
    fn before(&self, body: usize) -> (Option<usize>, usize) {
        let joint = self.linkage.placing(body);
        (self.linkage.joints[joint].0, joint)
    }

    fn is_piston(&self, body: usize) -> bool {
        self.linkage.bodies[body] == Piston
    }

    fn parameters(&self) -> String {
        let bodies = self.each(|b| {
            format!("m_{b} [kg] = 1; J_{b} [kg*m^2] = 0.1; th_{b} [rad] = 0; X_{b} [m] = 0; Y_{b} [m] = 0;\n")
        });
        let places = |j: usize| format!("ax_{j} [m] = 1; ay_{j} [m] = 0; bx_{j} [m] = 1; by_{j} [m] = 0;\n");
        let joints: String = (0..self.linkage.joints.len()).map(places).collect();
        format!(
            "parameters {{\n{bodies}{joints}e0 [m] = 0; w [rad/s] = 1; g [m/s^2] = 0; T [N*m] = 0; k [N/m] = 0; l0 [m] = 1; \
             sx [m] = 0; sy [m] = 0; kd [N*m*s] = 0; tilt [rad] = 0.3;\n}}\n{}",
            if self.is_spatial() {
                "let st = sin(tilt);\nlet ct = cos(tilt);\nlet up = [0, st, ct];\nlet n = [0, -ct, st];\n"
            } else {
                ""
            }
        )
    }

    /// A vector with components in the plane.
    fn vector(&self, x: &str, y: &str) -> String {
        match (self.is_spatial(), y) {
            (false, _) => format!("[{x}, {y}]"),
            (true, "0") => format!("[{x}, 0, 0]"),
            (true, _) => format!("[{x}, {y}*st, {y}*ct]"),
        }
    }

    /// Where joint j is on one of its bodies, in that body's frame.
    fn place(&self, side: char, joint: usize, body: Option<usize>) -> String {
        let across = match body.map(|body| self.linkage.bodies[body]) {
            Some(Bar | Piston) => "0".to_owned(),
            Some(Plate) | None => format!("{side}y_{joint}"),
        };
        let along =
            if body.is_some_and(|body| self.is_piston(body)) { "0".to_owned() } else { format!("{side}x_{joint}") };
        self.vector(&along, &across)
    }

    /// The same in the world.
    fn point(&self, side: char, joint: usize, body: Option<usize>) -> String {
        let place = self.place(side, joint, body);
        match body {
            None => place,
            Some(body) if self.form == Reduced => {
                let parts: Vec<&str> = place.trim_matches(['[', ']']).split(", ").collect();
                format!("(G_{body} + {}*u_{body} + {}*v_{body})", parts[0], parts[1])
            }
            Some(body) => format!("on(b_{body}, {place})"),
        }
    }

    fn coordinates(&self) -> String {
        let turning = |b: &usize| !self.is_piston(*b);
        let names: Vec<String> = match self.form {
            Absolute => (0..self.linkage.bodies.len()).filter(turning).map(|b| format!("phi_{b} [rad];")).collect(),
            Relative => (0..self.linkage.bodies.len()).filter(turning).map(|b| format!("rel_{b} [rad];")).collect(),
            Reduced => vec!["phi_0 [rad];".to_owned()],
            Free | Joints | Quaternions => return String::new(),
        };
        format!("coordinates {{ {} }}\n", names.join(" "))
    }

    fn bodies(&self) -> String {
        let body = |b: usize| match self.form {
            Absolute | Relative | Reduced => self.placed_body(b),
            Free => format!("bodies {{ b_{b}: free, mass m_{b}, inertia J_{b}; }}\nlet phi_{b} = b_{b}_phi;\n"),
            Joints => format!("bodies {{ b_{b}: mass m_{b}, inertia [J_{b}/2, J_{b}, J_{b}]; }}\n"),
            Quaternions => {
                let ahead = format!("let e_{b} = attitude(b_{b})*[1, 0, 0];\n");
                let free = format!("bodies {{ b_{b}: free, mass m_{b}, inertia [J_{b}/2, J_{b}, J_{b}]; }}\n");
                format!("{free}{ahead}let phi_{b} = atan2(inner(e_{b}, up), e_{b}.x);\n")
            }
        };
        let angle = |b: usize| match (self.form, self.before(b)) {
            (Joints, (None, j)) => format!("let phi_{b} = j_{j};\n"),
            (Joints, (Some(a), j)) => format!("let phi_{b} = phi_{a} + j_{j};\n"),
            _ => String::new(),
        };
        self.each(body) + &self.each(angle)
    }

    /// A body whose angle is known, placed by its first joint.
    fn placed_body(&self, b: usize) -> String {
        let (before, j) = self.before(b);
        let joint = self.point('a', j, before);
        if self.is_piston(b) {
            return format!("let G_{b} = {joint};\nbodies {{ b_{b}: mass m_{b} at G_{b}; }}\n");
        }
        let angle = match (self.form, before) {
            (Relative, None) => format!("let phi_{b} = rel_{b};\n"),
            (Relative, Some(a)) => format!("let phi_{b} = phi_{a} + rel_{b};\n"),
            (Reduced, _) if b == 0 => String::new(),
            (Reduced, _) if self.linkage.is_crank(b) => format!("let phi_{b} = phi_0 + (th_{b} - th_0);\n"),
            (Reduced, _) => format!("let phi_{b} = th_{b};\n"),
            _ => String::new(),
        };
        let frame = format!("let u_{b} = [cos(phi_{b}), sin(phi_{b})];\nlet v_{b} = [-sin(phi_{b}), cos(phi_{b})];\n");
        let across = if self.linkage.bodies[b] == Plate { format!(" - by_{j}*v_{b}") } else { String::new() };
        let turning = match self.form == Reduced && !self.linkage.is_crank(b) {
            true => String::new(),
            false => format!(", inertia J_{b}, angle phi_{b}"),
        };
        format!(
            "{angle}{frame}let G_{b} = {joint} - bx_{j}*u_{b}{across};\nbodies {{ b_{b}: mass m_{b} at G_{b}{turning}; }}\n"
        )
    }

    fn joints(&self) -> String {
        let all: Vec<usize> = match self.form {
            Reduced => return String::new(),
            Absolute | Relative => self.linkage.cuts().collect(),
            Free | Joints | Quaternions => (0..self.linkage.joints.len()).collect(),
        };
        let joint = |j: usize| {
            let Joint(a, b) = self.linkage.joints[j];
            if self.is_spatial() {
                let body = a.map_or("ground".to_owned(), |a| format!("b_{a}"));
                let (first, second) = (self.place('a', j, a), self.place('b', j, Some(b)));
                return format!(
                    "j_{j}: revolute {body} at {first} axis [0, -ct, st] to b_{b} at {second} axis [0, -ct, st];\n"
                );
            }
            format!("j_{j}: pin {} to {};\n", self.point('a', j, a), self.point('b', j, Some(b)))
        };
        let pins: String = all.into_iter().map(joint).collect();
        let pistons = (0..self.linkage.bodies.len()).filter(|b| self.is_piston(*b));
        let guides: String = pistons
            .map(|b| match self.form {
                Free => format!("joints {{ guide: slide b_{b} through [0, e0] along 0; }}\n"),
                _ => format!("constraints {{ guide: G_{b}.y = e0; }}\n"),
            })
            .collect();
        if pins.is_empty() { guides } else { format!("joints {{\n{pins}}}\n{guides}") }
    }

    fn loads(&self) -> String {
        let last = (0..self.linkage.bodies.len()).rev().find(|b| !self.is_piston(*b)).unwrap_or(0);
        let spring = format!("spring k, length l0 from {} to {};", self.vector("sx", "sy"), self.centre(1));
        if self.is_spatial() {
            return format!(
                "loads {{ gravity -g*up; torque T*n on b_0; {spring} torque -kd*inner(omega(b_{last}), n)*n on b_{last}; }}\n"
            );
        }
        format!("loads {{ gravity [0, -g]; torque T on b_0; {spring} torque -kd*dot(phi_{last}) on b_{last}; }}\n")
    }

    /// The centre of mass of a body.
    fn centre(&self, b: usize) -> String {
        match self.form {
            Absolute | Relative | Reduced => format!("G_{b}"),
            Free => format!("on(b_{b}, [0, 0])"),
            Joints | Quaternions => format!("on(b_{b}, [0, 0, 0])"),
        }
    }

    fn initial(&self) -> String {
        let line = |b: usize| {
            let guess = if b == 0 { "" } else { "guess " };
            let speed = |q: &str| if b == 0 { format!(" dot({q}) = w;") } else { String::new() };
            match (self.form, self.before(b)) {
                (Absolute | Relative, _) if self.is_piston(b) => String::new(),
                (Reduced, _) if b > 0 => String::new(),
                (Absolute | Reduced, _) | (Relative, (None, _)) => {
                    let q = if self.form == Relative { format!("rel_{b}") } else { format!("phi_{b}") };
                    format!("{guess}{q} = th_{b};{}\n", speed(&q))
                }
                (Relative, (Some(a), _)) => format!("{guess}rel_{b} = th_{b} - th_{a};\n"),
                (Free, _) => {
                    let q = format!("b_{b}_phi");
                    format!("{guess}{q} = th_{b};{} guess b_{b}_x = X_{b}; guess b_{b}_y = Y_{b};\n", speed(&q))
                }
                (Joints, (None, j)) => format!("{guess}j_{j} = th_{b};{}\n", speed(&format!("j_{j}"))),
                (Joints, (Some(a), j)) => format!("{guess}j_{j} = th_{b} - th_{a};\n"),
                (Quaternions, _) => self.quaternion_start(b, guess),
            }
        };
        format!("initial {{\n{}}}\n", self.each(line))
    }

    fn quaternion_start(&self, b: usize, guess: &str) -> String {
        let q = [format!("cos(th_{b}/2)"), "0".to_owned(), format!("-sin(th_{b}/2)*ct"), format!("sin(th_{b}/2)*st")];
        let rates = ["-sin(th_0/2)*w/2", "0", "-cos(th_0/2)*w/2*ct", "cos(th_0/2)*w/2*st"];
        let mut text = format!("guess b_{b}_x = X_{b}; guess b_{b}_y = Y_{b}*st; guess b_{b}_z = Y_{b}*ct;\n");
        for i in 0..4 {
            text += &format!("{guess}b_{b}_q{i} = {}; ", q[i]);
            if b == 0 {
                text += &format!("dot(b_{b}_q{i}) = {}; ", rates[i]);
            }
        }
        text + "\n"
    }

    fn outputs(&self) -> String {
        let body = |b: usize| {
            let centre = self.centre(b);
            let y = if self.is_spatial() { format!("inner({centre}, up)") } else { format!("{centre}.y") };
            let mut text = String::new();
            for (name, of) in [("x", format!("{centre}.x")), ("y", y)] {
                text += &format!(
                    "{name}_{b} [m] = {of}; v{name}_{b} [m/s] = dot({of}); a{name}_{b} [m/s^2] = ddot({of});\n"
                );
            }
            let turns = !self.is_piston(b) && (self.form != Reduced || self.linkage.is_crank(b));
            if turns {
                let (rate, second) = match self.form {
                    Quaternions => (format!("inner(omega(b_{b}), n)"), format!("dot(inner(omega(b_{b}), n))")),
                    _ => (format!("dot(phi_{b})"), format!("ddot(phi_{b})")),
                };
                text += &format!("angle_{b} [rad] = phi_{b}; w_{b} [rad/s] = {rate}; e_{b} [rad/s^2] = {second};\n");
            }
            text
        };
        let force = |j: usize| match self.is_spatial() {
            true => format!("fx_{j} [N] = reaction(j_{j}).x; fy_{j} [N] = inner(reaction(j_{j}), up);\n"),
            false => format!("fx_{j} [N] = reaction(j_{j}).x; fy_{j} [N] = reaction(j_{j}).y;\n"),
        };
        let mut forces = String::new();
        if self.linkage.has_reactions && self.form != Reduced {
            forces = self.linkage.cuts().map(force).collect();
            let guided = self.linkage.bodies.contains(&Piston);
            forces += if guided { "push [N] = reaction(guide);\n" } else { "" };
        }
        format!("outputs {{\n{}{forces}}}\n", self.each(body))
    }
}
