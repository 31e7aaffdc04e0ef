//! The text of a URDF to a robot.

use super::number::Number;
use super::pose::{is_straightened, roll_pitch_yaw};
use super::robot::{Geometry, Inertial, Joint, Kind, Limit, Link, Mimicked, Origin, Place, Robot, Visual};
use super::warnings::{CODE, Warnings};
use super::xml::{ATTRIBUTES, MACRO, MOST_NODES, child, is_of_xacro, is_plain, malformed, short, tag, value};
use codegen::mistakes::Mistake;
use codegen::nearest;
use indexmap::IndexMap;
use nalgebra::Vector3;
use roxmltree::{Document, Node, ParsingOptions};

/// So many mistakes are told.
const MOST_MISTAKES: usize = 50;

/// Among so many names one is sought that is meant.
const MOST_NAMES: usize = 1000;

/// Reads a robot. Angles within `straight` of a quarter turn are such.
pub(super) fn read<'t>(text: &'t str, straight: f64, warnings: &mut Warnings<'t>) -> Result<Robot, Vec<Mistake>> {
    let options = ParsingOptions { nodes_limit: MOST_NODES, ..ParsingOptions::default() };
    let document = Document::parse_with_options(text, options).map_err(|error| vec![malformed(text, &error)])?;
    let mut reader = Reader { text, straight, warnings, mistakes: Vec::new(), ignored: IndexMap::new() };
    let robot = reader.robot(document.root_element());
    reader.warn_of_ignored();
    match robot {
        Some(robot) if reader.mistakes.is_empty() => Ok(robot),
        _ => Err(reader.mistakes),
    }
}

struct Reader<'t, 'w> {
    text: &'t str,
    straight: f64,
    warnings: &'w mut Warnings<'t>,
    mistakes: Vec<Mistake>,
    /// Elements and attributes that are left out, by what is told of them: how many, and where the first is.
    ignored: IndexMap<String, (usize, Place)>,
}

impl Reader<'_, '_> {
    fn refuse<T>(&mut self, place: Place, message: impl Into<String>) -> Option<T> {
        if self.mistakes.len() < MOST_MISTAKES {
            self.mistakes.push(Mistake::at(self.text, CODE, place, message.into()));
        }
        None
    }

    /// ` (did you mean ..?)`, as long as there are not too many to look through.
    fn suggestion<'n>(&self, word: &str, known: impl ExactSizeIterator<Item = &'n str>) -> String {
        let is_quick = known.len() <= MOST_NAMES && self.mistakes.len() < MOST_MISTAKES;
        if is_quick { nearest::suggestion(word, known) } else { String::new() }
    }

    fn robot(&mut self, root: Node) -> Option<Robot> {
        let name = root.tag_name().name();
        if name != "robot" {
            let message = format!("this is `<{name}>`, and the root of a URDF is `<robot name=\"..\">`");
            return self.refuse(tag(root), message);
        }
        let is_read = |node: &Node| is_plain(*node, "link") || is_plain(*node, "joint");
        let read =
            root.children().flat_map(|node| node.descendants().take(if is_read(&node) { usize::MAX } else { 1 }));
        if let Some(node) = read.into_iter().find(|node| node.is_element() && is_of_xacro(*node)) {
            return self.refuse(tag(node), MACRO);
        }
        let elements = || root.children().filter(Node::is_element);
        let named = |name: &'static str| elements().filter(move |node| is_plain(*node, name));
        let places = self.places("link", named("link").collect());
        self.places("joint", named("joint").collect());
        let links: Vec<Option<Link>> = named("link").map(|node| self.link(node)).collect();
        let joints: Vec<Option<Joint>> = named("joint").map(|node| self.joint(node, &places)).collect();
        let is_known = |node: &Node| ["link", "joint", "material"].iter().any(|name| is_plain(*node, name));
        for node in elements().filter(|node| !is_known(node)) {
            self.ignore(node);
        }
        elements().filter(|node| is_read(node)).for_each(|node| self.ignore_attributes(node));
        if links.is_empty() {
            return self.refuse(tag(root), "there is no robot here: a robot has a `<link name=\"..\">` at least");
        }
        let name = root.attribute("name").unwrap_or("robot").to_owned();
        Some(Robot {
            name,
            links: links.into_iter().collect::<Option<_>>()?,
            joints: joints.into_iter().collect::<Option<_>>()?,
        })
    }

    /// Elements by their names, which are to differ.
    fn places(&mut self, what: &str, nodes: Vec<Node>) -> IndexMap<String, usize> {
        let mut places = IndexMap::new();
        for (at, node) in nodes.into_iter().enumerate() {
            let Some(name) = node.attribute("name") else { continue };
            if places.insert(name.to_owned(), at).is_some() {
                self.refuse::<()>(tag(node), format!("two {what}s are called `{}`", short(name)));
            }
        }
        places
    }

    fn link(&mut self, node: Node) -> Option<Link> {
        let name = self.required(node, "name")?.to_owned();
        let mut link = Link { name, place: tag(node), inertial: None, visuals: Vec::new() };
        let mut is_sound = true;
        for part in node.children().filter(Node::is_element) {
            match part.tag_name().name() {
                "inertial" if link.inertial.is_some() => self.warn_of_second(part),
                "inertial" => {
                    link.inertial = self.inertial(part);
                    is_sound &= link.inertial.is_some();
                }
                "visual" => {
                    let before = self.mistakes.len();
                    link.visuals.extend(self.visual(part));
                    // A picture less is no mistake.
                    for mistake in self.mistakes.split_off(before) {
                        let place = mistake.start.byte..mistake.end.byte;
                        self.warnings.add(&place, format!("{}; this is not drawn", mistake.message));
                    }
                }
                "collision" => {}
                _ => self.ignore(part),
            }
        }
        is_sound.then_some(link)
    }

    fn inertial(&mut self, node: Node) -> Option<Inertial> {
        let origin = self.origin(node)?;
        let mass = match child(node, "mass") {
            Some(mass) => self.number(mass, "value")?,
            None => None,
        };
        let place = child(node, "inertia").map_or_else(|| tag(node), tag);
        let mut inertia = [Number::ZERO; 6];
        let mut missing = Vec::new();
        if let Some(given) = child(node, "inertia") {
            for (entry, name) in inertia.iter_mut().zip(["ixx", "iyy", "izz", "ixy", "ixz", "iyz"]) {
                match self.number(given, name)? {
                    Some(number) => *entry = number,
                    None => missing.push(name),
                }
            }
        }
        let mass = mass.unwrap_or_else(|| {
            missing.insert(0, "a mass");
            Number::ZERO
        });
        if mass.value < 0.0 {
            return self.refuse(child(node, "mass").map_or(place, tag), "a mass cannot be negative");
        }
        if !missing.is_empty() {
            self.warnings.add(&place, format!("this lacks {}, which is taken as 0", missing.join(", ")));
        }
        Some(Inertial { place, origin, mass, inertia })
    }

    /// What is seen; nothing where its form is not known, which is no more than a picture less.
    fn visual(&mut self, node: Node) -> Option<Visual> {
        let origin = self.origin(node)?;
        let geometry = child(node, "geometry")?.children().find(Node::is_element)?;
        let place = tag(geometry);
        let geometry = match geometry.tag_name().name() {
            "box" => Geometry::Box(self.three(geometry, "size")?.map(|number| number.value)),
            "cylinder" => {
                let [radius, length] = ["radius", "length"].map(|name| self.number(geometry, name).flatten());
                Geometry::Cylinder { radius: radius?.value, length: length?.value }
            }
            "sphere" => Geometry::Sphere(self.number(geometry, "radius")??.value),
            "mesh" => {
                let scale = match geometry.attribute("scale") {
                    Some(_) => self.three(geometry, "scale")?.map(|number| number.value),
                    None => [1.0; 3],
                };
                Geometry::Mesh { file: self.required(geometry, "filename")?.to_owned(), scale }
            }
            other => {
                self.warnings.add(&place, format!("`{other}` is not drawn; known are box, cylinder, sphere and mesh"));
                return None;
            }
        };
        Some(Visual { place, origin, geometry })
    }

    fn joint(&mut self, node: Node, links: &IndexMap<String, usize>) -> Option<Joint> {
        let (name, kind) = (self.required(node, "name"), self.kind(node));
        let parent = self.linked(node, "parent", links);
        let child = self.linked(node, "child", links);
        let (name, kind) = (name?.to_owned(), kind?);
        let origin = self.origin(node)?;
        let axis = self.axis(node, kind)?;
        let limit = self.limit(node, kind, &name)?;
        let [damping, friction] = self.dynamics(node, kind)?;
        let mimic = self.mimic(node)?;
        for (at, part) in node.children().filter(Node::is_element).enumerate() {
            let mut before = node.children().filter(Node::is_element).take(at);
            if before.any(|other| other.tag_name().name() == part.tag_name().name()) {
                self.warn_of_second(part);
            }
        }
        const KNOWN: [&str; 7] = ["parent", "child", "origin", "axis", "limit", "dynamics", "mimic"];
        for part in node.children().filter(|part| part.is_element() && !KNOWN.contains(&part.tag_name().name())) {
            self.ignore(part);
        }
        let (parent, child) = (parent?, child?);
        Some(Joint { name, place: tag(node), kind, parent, child, origin, axis, limit, damping, friction, mimic })
    }

    fn kind(&mut self, node: Node) -> Option<Kind> {
        let word = self.required(node, "type")?;
        let known = Kind::ALL.iter().find(|(name, _)| *name == word);
        if let Some((_, kind)) = known {
            return Some(*kind);
        }
        let names = Kind::ALL.map(|(name, _)| name);
        let near = nearest::suggestion(word, names.iter().copied());
        let message = format!("no joint is of the type `{word}`{near}; known are {}", names.join(", "));
        self.refuse(value(node, "type"), message)
    }

    /// The link that `parent` or `child` names.
    fn linked(&mut self, node: Node, what: &str, links: &IndexMap<String, usize>) -> Option<usize> {
        let Some(part) = child(node, what) else {
            let name = node.attribute("name").unwrap_or_default();
            return self.refuse(tag(node), format!("joint `{name}` has no `<{what} link=\"..\"/>`"));
        };
        let name = self.required(part, "link")?;
        let found = links.get(name).copied();
        found.or_else(|| {
            let near = self.suggestion(name, links.keys().map(String::as_str));
            self.refuse(value(part, "link"), format!("no link is called `{name}`{near}"))
        })
    }

    fn axis(&mut self, node: Node, kind: Kind) -> Option<Vector3<f64>> {
        let Some(part) = child(node, "axis").filter(|part| part.has_attribute("xyz")) else {
            return Some(Vector3::x());
        };
        let given = Vector3::from(self.three(part, "xyz")?.map(|number| number.value));
        if !kind.is_single() && kind != Kind::Planar {
            return Some(given);
        }
        let size = given.abs().max();
        if size == 0.0 {
            return self.refuse(value(part, "xyz"), "an axis has a direction, and this one is 0");
        }
        // Scaled first, so that no square leaves the range of numbers.
        let axis = (given / size).normalize();
        let straight = axis.map(|x| if x.abs() <= self.straight { 0.0 } else { x });
        if straight != axis && self.straight > super::Options::STRAIGHT {
            self.warnings.add(&value(part, "xyz"), "this axis is set straight");
        }
        Some(straight.normalize())
    }

    fn limit(&mut self, node: Node, kind: Kind, name: &str) -> Option<Option<Limit>> {
        let has_range = matches!(kind, Kind::Revolute | Kind::Prismatic);
        let Some(part) = child(node, "limit") else {
            if has_range {
                self.warnings.add(&tag(node), format!("joint `{name}` has no limit, and moves without one"));
            }
            return Some(None);
        };
        let place = tag(part);
        let [lower, upper] = [self.number(part, "lower")?, self.number(part, "upper")?];
        let [effort, velocity] = [self.number(part, "effort")?, self.number(part, "velocity")?];
        let is_given = lower.is_some() || upper.is_some();
        let range = [lower.unwrap_or(Number::ZERO), upper.unwrap_or(Number::ZERO)];
        let mut limit = Limit { place, range: None, effort, velocity };
        if has_range {
            let [least, greatest] = range.each_ref().map(|number| number.value);
            let [from, to] = &range;
            if !is_given {
                self.warnings.add(&limit.place, format!("joint `{name}` has no range, and moves without one"));
            } else if least < greatest {
                limit.range = Some(range);
            } else {
                let message = format!("joint `{name}` cannot move from {from} to {to}; it moves without a range");
                self.warnings.add(&limit.place, message);
            }
        }
        Some(Some(limit))
    }

    /// Damping and friction.
    fn dynamics(&mut self, node: Node, kind: Kind) -> Option<[Number; 2]> {
        let mut found = [Number::ZERO; 2];
        let Some(part) = child(node, "dynamics") else { return Some(found) };
        for (number, name) in found.iter_mut().zip(["damping", "friction"]) {
            let given = self.number(part, name)?.unwrap_or(Number::ZERO);
            if !kind.is_single() {
                if given.value != 0.0 {
                    let message = format!("{name} is known of joints with one coordinate; here it is left out");
                    self.warnings.add(&value(part, name), message);
                }
                continue;
            }
            if given.value < 0.0 {
                self.warnings.add(&value(part, name), format!("negative {name} would drive the joint; it is left out"));
                continue;
            }
            *number = given;
        }
        Some(found)
    }

    fn mimic(&mut self, node: Node) -> Option<Option<Mimicked>> {
        let Some(part) = child(node, "mimic") else { return Some(None) };
        let joint = self.required(part, "joint")?.to_owned();
        let multiplier = self.number(part, "multiplier")?.unwrap_or(Number::ONE);
        let offset = self.number(part, "offset")?.unwrap_or(Number::ZERO);
        Some(Some(Mimicked { place: tag(part), joint, multiplier, offset }))
    }

    fn origin(&mut self, node: Node) -> Option<Origin> {
        let Some(part) = child(node, "origin") else { return Some(Origin::none()) };
        if part.has_attribute("quat_xyzw") {
            return self.refuse(value(part, "quat_xyzw"), "quaternions are not read; give the rotation by `rpy`");
        }
        let xyz = if part.has_attribute("xyz") { self.three(part, "xyz")? } else { [Number::ZERO; 3] };
        let rpy = if part.has_attribute("rpy") { self.three(part, "rpy")?.map(|angle| angle.value) } else { [0.0; 3] };
        let is_asked = self.straight > super::Options::STRAIGHT;
        if is_asked && rpy.iter().any(|angle| is_straightened(*angle, self.straight)) {
            self.warnings.add(&value(part, "rpy"), "this rotation is set straight");
        }
        Some(Origin { xyz, rotation: roll_pitch_yaw(rpy, self.straight) })
    }

    /// An attribute that must be there.
    fn required<'n>(&mut self, node: Node<'n, '_>, name: &str) -> Option<&'n str> {
        let found = node.attribute(name);
        found.or_else(|| {
            let element = node.tag_name().name();
            self.refuse(tag(node), format!("`<{element}>` needs the attribute `{name}`"))
        })
    }

    /// The number of an attribute, if it is there.
    fn number(&mut self, node: Node, name: &str) -> Option<Option<Number>> {
        let Some(text) = node.attribute(name) else { return Some(None) };
        match Number::read(text.trim()) {
            Some(number) => Some(Some(number)),
            None => self.refuse(value(node, name), format!("`{}` is not a number", short(text))),
        }
    }

    /// The three numbers of an attribute.
    fn three(&mut self, node: Node, name: &str) -> Option<[Number; 3]> {
        let text = self.required(node, name)?;
        let numbers: Option<Vec<Number>> = text.split_whitespace().map(Number::read).collect();
        let found = numbers.and_then(|numbers| <[Number; 3]>::try_from(numbers).ok());
        found.or_else(|| {
            self.refuse(value(node, name), format!("`{}` is not three numbers, as in `0 0 0.1`", short(text)))
        })
    }

    fn warn_of_second(&mut self, part: Node) {
        self.warnings.add(&tag(part), format!("a second `{}` is left out: the first counts", part.tag_name().name()));
    }

    fn ignore(&mut self, node: Node) {
        self.count_ignored(format!("`{}`", short(node.tag_name().name())), tag(node));
    }

    fn count_ignored(&mut self, what: String, place: Place) {
        let (count, _) = self.ignored.entry(what).or_insert((0, place));
        *count += 1;
    }

    /// Leaves out the attributes of links, joints and their parts that are not known; what is drawn may have any.
    fn ignore_attributes(&mut self, node: Node) {
        let name = node.tag_name().name();
        let Some((_, known)) = ATTRIBUTES.iter().find(|(element, _)| *element == name) else { return };
        for attribute in node.attributes().filter(|attribute| attribute.namespace().is_none()) {
            if !known.contains(&attribute.name()) {
                let near = nearest::suggestion(attribute.name(), known.iter().copied());
                self.count_ignored(format!("`{}` of `{name}`{near}", short(attribute.name())), attribute.range());
            }
        }
        node.children().filter(Node::is_element).for_each(|part| self.ignore_attributes(part));
    }

    fn warn_of_ignored(&mut self) {
        for (what, (count, place)) in std::mem::take(&mut self.ignored) {
            let others = if count > 1 { format!(", here and {} times more", count - 1) } else { String::new() };
            self.warnings.add(&place, format!("{what} is ignored{others}"));
        }
    }
}
