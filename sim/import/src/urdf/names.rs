//! Names of a declaration for those of a robot.

use codegen::model;
use std::collections::{HashMap, HashSet};

/// Names that are taken, in a declaration where every name stands for one thing.
pub(super) struct Names {
    taken: HashSet<String>,
    /// The last number after a name that several wished.
    numbers: HashMap<String, usize>,
}

impl Names {
    pub(super) fn none() -> Names {
        Names { taken: HashSet::new(), numbers: HashMap::new() }
    }

    /// A name near the wished one: itself where it is a name of the language and still free, else with other letters, the
    /// kind of thing after it or a number.
    pub(super) fn take(&mut self, wished: &str, kind: &str) -> String {
        self.take_with(wished, kind, &[])
    }

    /// The same for coordinates, each the name with an ending; they have speeds and accelerations, so named.
    pub(super) fn take_with(&mut self, wished: &str, kind: &str, endings: &[&str]) -> String {
        let near = letters(wished, kind);
        let all = |name: &String| {
            let own = name.clone();
            let coordinates =
                endings.iter().flat_map(|ending| ["", "_dot", "_ddot"].map(|rate| format!("{name}{ending}{rate}")));
            [own].into_iter().chain(coordinates).collect::<Vec<_>>()
        };
        let is_free = |name: &String| all(name).iter().all(|name| !self.taken.contains(name));
        let with_kind = format!("{near}_{kind}");
        let last = self.numbers.entry(with_kind.clone()).or_insert(1);
        let mut name = if is_name(&near) { near } else { with_kind.clone() };
        if !is_free(&name) {
            name = with_kind.clone();
        }
        while !is_free(&name) {
            *last += 1;
            name = format!("{with_kind}_{last}");
        }
        self.taken.extend(all(&name));
        name
    }
}

/// Beginnings of names that the language makes: of what defines frames, and of columns of sweeps.
const MADE: [&str; 5] = ["place_of_", "attitude_of_", "drive_", "ratio_", "advantage_"];

/// A word with `_` for all that no name has; with the kind of thing after it, it is a name.
fn letters(wished: &str, kind: &str) -> String {
    let with = |is_letter: fn(char) -> bool| -> String {
        wished.trim().chars().map(|c| if is_letter(c) || c == '_' { c } else { '_' }).collect()
    };
    let kept = with(char::is_alphanumeric);
    // Some letters stand in no name.
    let kept = if is_name(&format!("a{kept}a")) { kept } else { with(|c| c.is_ascii_alphanumeric()) };
    // An index stands after a name that ends in `_`.
    let kept = kept.trim_end_matches('_');
    let is_beginning = |first: char| is_name(&format!("{first}a")) || (first == '_' && is_name(kept));
    match kept.chars().next() {
        None => kind.to_owned(),
        Some(first) if is_beginning(first) && !MADE.iter().any(|made| kept.starts_with(made)) => kept.to_owned(),
        Some(_) => format!("{kind}_{}", kept.trim_start_matches('_')),
    }
}

/// Whether the language takes it as a name of anything.
fn is_name(text: &str) -> bool {
    // `x`, `y` and `z` are axes, unless a name hides them; `S` is the generated code's.
    const OTHERS: [&str; 9] = ["x", "y", "z", "S", "ground", "work", "stretch", "rate", "transmission_index"];
    model::is_name(text) && !OTHERS.contains(&text)
}

/// The name of the mechanism: `PandaArm` for `panda_arm`.
pub(super) fn type_name(robot: &str) -> String {
    let words = robot.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
    let capital = |word: &str| {
        let mut letters = word.chars();
        letters.next().map(|first| first.to_uppercase().chain(letters).collect::<String>()).unwrap_or_default()
    };
    let name: String = words.map(capital).collect();
    let plain = || name.chars().filter(char::is_ascii_alphanumeric).collect::<String>();
    match name.chars().next() {
        Some(first) if first.is_alphabetic() && is_name(&name) => name,
        _ if is_name(&format!("Robot{name}")) => format!("Robot{name}"),
        _ => format!("Robot{}", plain()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_kept_where_they_are_names() {
        let mut names = Names::none();
        assert_eq!(names.take("upper_arm", "link"), "upper_arm");
        assert_eq!(names.take("upper_arm", "link"), "upper_arm_link");
        assert_eq!(names.take("upper_arm", "link"), "upper_arm_link_2");
        assert_eq!(names.take("link_8.0", "link"), "link_8_0");
        assert_eq!(names.take("8", "link"), "link_8");
        assert_eq!(names.take("", "link"), "link");
        assert_eq!(names.take("tip_", "link"), "tip");
        assert_eq!(names.take("</script>", "link"), "__script"); // Inert.
    }

    #[test]
    fn words_of_the_language_and_of_rust_are_no_names() {
        let mut names = Names::none();
        for word in ["t", "e", "sin", "type", "self", "true", "rotation", "attitude", "x", "on"] {
            assert_eq!(names.take(word, "joint"), format!("{word}_joint"));
        }
    }

    /// Letters that stand in no name of Rust, and names that the language makes itself.
    #[test]
    fn other_letters_and_made_names_are_changed() {
        let mut names = Names::none();
        assert_eq!(names.take("m\u{b2}", "link"), "m");
        assert_eq!(names.take("\u{24d0}", "link"), "link");
        assert_eq!(names.take("\u{24d0}", "link"), "link_link");
        assert_eq!(names.take("place_of_a", "joint"), "joint_place_of_a");
        assert_eq!(type_name("arm\u{b2}"), "RobotArm");
        // Numbers go on from the last: many of one name take no time.
        (0..5000).for_each(|_| drop(names.take("same", "link")));
        assert_eq!(names.take("same", "link"), "same_link_5000");
    }

    #[test]
    fn a_coordinates_rates_have_names_too() {
        let mut names = Names::none();
        assert_eq!(names.take("hip_dot", "joint"), "hip_dot");
        assert_eq!(names.take_with("hip", "joint", &[""]), "hip_joint");
    }

    #[test]
    fn mechanisms_are_named_as_types() {
        let names = [
            ("panda_arm", "PandaArm"),
            ("2 legs", "Robot2Legs"),
            ("", "Robot"),
            ("S", "RobotS"),
            ("Self", "RobotSelf"),
        ];
        for (robot, name) in names {
            assert_eq!(type_name(robot), name);
        }
    }
}
