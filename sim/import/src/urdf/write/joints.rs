//! Joints: coordinates, drives, damping, limits.

use super::blocks::Blocks;
use super::{Named, Written, one_line};
use crate::urdf::Mimic;
use crate::urdf::mimic::Law;
use crate::urdf::names::Names;
use crate::urdf::number::Number;
use crate::urdf::robot::{Joint, Kind};

/// Where friction is nearly whole, in rad/s or m/s.
const SLOW: &str = "0.05";

/// A limit is passed so far beyond it, in rad or m.
const BEYOND: &str = "1e-9";

impl Written<'_> {
    /// The value of a joint of one coordinate.
    pub(super) fn value(&self, named: &Named, joint: usize) -> String {
        if self.is_substituted(joint) { self.followed(named, joint) } else { named.joints[joint].clone() }
    }

    /// A joint's value by that of the joint that it follows.
    fn followed(&self, named: &Named, joint: usize) -> String {
        let Some(law) = self.followers.law(joint) else { return named.joints[joint].clone() };
        let value = &named.joints[law.joint];
        let [own, theirs] = [joint, law.joint].map(|joint| self.robot.joints[joint].kind == Kind::Prismatic);
        let multiplier = match (own, theirs) {
            (true, false) => format!("{} [m]", law.multiplier),
            (false, true) => format!("{} [1/m]", law.multiplier),
            _ => law.multiplier.to_string(),
        };
        if own == theirs && law.multiplier.value == 1.0 && law.offset.is_zero() {
            return value.clone();
        }
        let offset = if law.offset.is_zero() {
            String::new()
        } else {
            format!(" + {}", law.offset.with(self.robot.joints[joint].kind.unit()))
        };
        format!("({multiplier}*{value}{offset})")
    }

    /// Where a joint of one coordinate starts: at 0, or amid its range if that is outside, or where it follows another.
    pub(super) fn start_of(&self, joint: usize) -> f64 {
        if let Some(law) = self.followers.law(joint) {
            return law.value(self.start_of(law.joint));
        }
        match self.robot.joints[joint].limit.as_ref().and_then(|limit| limit.range.as_ref()) {
            Some([lower, upper]) if lower.value > 0.0 || upper.value < 0.0 => lower.value / 2.0 + upper.value / 2.0,
            _ => 0.0,
        }
    }

    /// Writes a joint of one coordinate.
    pub(super) fn joint(&self, named: &Named, joint: usize, names: &mut Names, blocks: &mut Blocks) {
        let Joint { kind, damping, friction, .. } = &self.robot.joints[joint];
        let (name, value) = (&named.joints[joint], self.value(named, joint));
        let unit = kind.unit();
        let [force, effort, damping_unit] =
            if *kind == Kind::Prismatic { ["force", "N", "N*s/m"] } else { ["torque", "N*m", "N*m*s"] };
        if !self.is_substituted(joint) {
            blocks.line("coordinates", format!("/// {}\n    {name} [{unit}];", self.docs(joint)));
            let drive = names.take(&format!("tau_{name}"), "drive");
            blocks.line("inputs", format!("{drive} [{effort}] = 0;"));
            blocks.line("loads", format!("{force} {drive} on {name};"));
            let (start, follows) = (self.start_of(joint), self.followers.law(joint));
            // Assembly would let a leader give way to its followers.
            if follows.is_none()
                && (start != 0.0 || self.followers.are_led_by(joint) && self.options.mimic == Mimic::Couple)
            {
                blocks.line("initial", format!("{name} = {};", Number::of(start)));
            }
            if let Some(Law { joint: other, .. }) = self.followers.law(joint) {
                let (coupling, value) =
                    (names.take(&format!("{name}_mimic"), "constraint"), self.followed(named, joint));
                blocks.line(
                    "constraints",
                    format!("/// As {}.\n    {coupling}: {name} = {value};", named.joints[*other]),
                );
            }
        }
        if self.options.damping && !damping.is_zero() {
            let parameter = names.take(&format!("{name}_damping"), "damping");
            blocks.line("parameters", format!("{parameter} [{damping_unit}] = {damping};"));
            blocks.line("loads", format!("damper {parameter} on {value};"));
        }
        if self.options.damping && !friction.is_zero() {
            let parameter = names.take(&format!("{name}_friction"), "friction");
            blocks.line("parameters", format!("{parameter} [{effort}] = {friction};"));
            blocks.line("loads", format!("friction {parameter}, smooth {SLOW} [{unit}/s] on {value};"));
        }
        self.limits(named, joint, names, blocks);
    }

    fn limits(&self, named: &Named, joint: usize, names: &mut Names, blocks: &mut Blocks) {
        let (of, name, value) = (&self.robot.joints[joint], &named.joints[joint], self.value(named, joint));
        let Some([lower, upper]) = of.limit.as_ref().and_then(|limit| limit.range.as_ref()) else { return };
        let unit = of.kind.unit();
        let (least, greatest) = (lower.with(unit), upper.with(unit));
        let minus = |number: &Number| match number.value {
            x if x < 0.0 => format!(
                " + {}",
                Number::read(number.to_string().trim_start_matches('-')).unwrap_or(Number::of(-x)).with(unit)
            ),
            0.0 => String::new(),
            _ => format!(" - {}", number.with(unit)),
        };
        let margin = names.take(&format!("{name}_margin"), "output");
        let block = if of.kind == Kind::Prismatic { "outputs_lengths" } else { "outputs_angles" };
        let distance = format!("min({value}{}, {greatest} - {value})", minus(lower));
        blocks.line(block, format!("{margin} [{unit}] = {distance};"));
        let sides = [("lower", lower, least, ["falling", "rising"]), ("upper", upper, greatest, ["rising", "falling"])];
        let stops = sides.into_iter().filter(|(_, at, ..)| self.comes_before_its_leader(joint, at.value));
        let mut stops = stops.filter(|_| self.options.stops).peekable();
        if stops.peek().is_none() {
            let event = names.take(&format!("{name}_limit"), "event");
            // Slightly beyond it, as many joints start on their limit.
            blocks.line("events", format!("{event}: {distance} = -{BEYOND} [{unit}] falling;"));
            return;
        }
        for (side, _, limit, [towards, away]) in stops {
            let [stop, hit, leave] =
                ["stop", "hit", "leave"].map(|what| names.take(&format!("{name}_{side}_{what}"), "stop"));
            blocks.line("constraints", format!("{stop}: {value} = {limit} initially released;"));
            blocks.line("events", format!("{hit}: {value} = {limit} {towards} {{ activate {stop}; }}"));
            blocks.line("events", format!("{leave}: reaction({stop}) = 0 {away} {{ release {stop}; }}"));
        }
    }

    /// Whether a limit of a joint comes before those of the joint that it follows, if it is written by that.
    fn comes_before_its_leader(&self, joint: usize, limit: f64) -> bool {
        let Some(law) = self.followers.law(joint).filter(|_| self.is_substituted(joint)) else { return true };
        let at = (limit - law.offset.value) / law.multiplier.value;
        let leader = self.robot.joints[law.joint].limit.as_ref().and_then(|limit| limit.range.as_ref());
        at.is_finite() && leader.is_none_or(|[lower, upper]| lower.value < at && at < upper.value)
    }

    /// What is told of a joint.
    fn docs(&self, joint: usize) -> String {
        let Joint { kind, limit, parent, child, .. } = &self.robot.joints[joint];
        let [parent, child] = [parent, child].map(|link| one_line(&self.robot.links[*link].name));
        let verb = if *kind == Kind::Prismatic { "Shifts" } else { "Turns" };
        let unit = kind.unit();
        let mut docs = format!("{verb} {child} against {parent}");
        let Some(limit) = limit else { return docs + "." };
        if let Some([lower, upper]) = &limit.range {
            let kept = if self.options.stops { "" } else { " (noted, not kept)" };
            docs += &format!(", from {lower} to {upper} {unit}{kept}");
        }
        let most = |number: &Option<Number>| number.as_ref().filter(|number| number.value > 0.0).map(Number::to_string);
        let effort = if *kind == Kind::Prismatic { "N" } else { "N*m" };
        let drive: Vec<String> =
            [(most(&limit.effort), effort.to_owned()), (most(&limit.velocity), format!("{unit}/s"))]
                .into_iter()
                .filter_map(|(most, unit)| Some(format!("{} {unit}", most?)))
                .collect();
        if !drive.is_empty() {
            docs += &format!("; at most {}", drive.join(" and "));
        }
        docs + "."
    }
}
