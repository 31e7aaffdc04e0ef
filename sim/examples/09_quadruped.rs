//! 9. A robot dropped on its feet: a quadruped from its URDF, with drives that hold its joints and feet that land, stick and lift.
//!
//! `sim import` gives the robot; what it meets is added in the language. The same text in a file would be run by
//! `sim run quadruped.mech`.
//!
//! `cargo run --release --example 09_quadruped`

use sim::import::urdf::{Base, Options};
use sim::show::{Curve, Plot, Size, panels};
use sim::{DeclarationFile, Erased, Mechanism, Settings, Table, declared_start, run};
use std::path::Path;

const LEGS: [&str; 4] = ["front_left", "front_right", "hind_left", "hind_right"];

/// The ground under a foot, springs and dampers that hold its leg, and where that starts.
fn leg(name: &str) -> String {
    let foot = format!("on({name}_foot, [0, 0, 0])");
    format!(
        "constraints {{
            {name}_ground: {foot}.z = radius initially released;
            {name}_sticks_x: dot({foot}).x = 0 initially released;
            {name}_sticks_y: dot({foot}).y = 0 initially released;
        }}
        events {{
            {name}_lands: {foot}.z = radius falling {{
                activate {name}_ground; activate {name}_sticks_x; activate {name}_sticks_y;
            }}
            {name}_lifts: reaction({name}_ground) = 0 rising {{
                release {name}_ground; release {name}_sticks_x; release {name}_sticks_y;
            }}
        }}
        loads {{
            spring stiffness, rest 0 on {name}_abduction; damper hold on {name}_abduction;
            spring stiffness, rest 0.7 on {name}_swing; damper hold on {name}_swing;
            spring stiffness, rest -1.4 on {name}_knee; damper hold on {name}_knee;
        }}
        outputs {{ {name}_pressure [N] = -reaction({name}_ground); }}"
    )
}

/// Where a coordinate starts: legs as their springs hold them, and the trunk turned a little, so that feet land one by one.
fn start(name: &str) -> Option<f64> {
    match name {
        "trunk_body_z" => Some(0.42),
        "trunk_body_q1" => Some(0.03),
        "trunk_body_q2" => Some(0.05),
        _ if name.ends_with("_swing") => Some(0.7),
        _ if name.ends_with("_knee") => Some(-1.4),
        _ => None,
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/examples/robots/quadruped.urdf"));
    let free = Options { base: Base::Free, ..Options::default() };
    let file = DeclarationFile::read(path)?.with_robots(free);
    let robot = file.robot().map_err(|why| why.to_string())?;
    let drives = "parameters { stiffness [N*m] = 80; hold [N*m*s] = 4; radius [m] = 0.02; }";
    let text = [robot.text.clone(), drives.to_owned(), LEGS.map(leg).join("\n")].join("\n");
    let model = DeclarationFile::of(Path::new("quadruped.mech"), text).model(None).map_err(|why| why.to_string())?;
    let robot = Erased::of(model);
    let mut begin = declared_start(&robot);
    for (at, coordinate) in robot.description().coordinates.iter().enumerate() {
        if let Some(value) = start(coordinate.position.name) {
            begin.positions[at] = value;
            begin.position_given[at] = true;
        }
    }
    let found = run(robot, &begin, &Settings::new(1.5))?;
    for event in &found.events {
        println!("{:<20} at {:.4} s", event.name, event.state.time);
    }
    let table = Table::of(&found.mechanism, &found.trajectory);
    let column = |name: &str| table.column(name).map_or(&[][..], |column| &column.values).to_vec();
    let times = column("t");
    let pressures = LEGS.map(|name| Curve { label: name, values: column(&format!("{name}_pressure")) });
    let height = Curve { label: "trunk", values: column("trunk_body_z") };
    let panel = |title, y_label, curves| Plot { title, x_label: "time [s]", y_label, x: &times, curves };
    let all =
        [panel("A landing on four feet", "height [m]", vec![height]), panel("", "pressure [N]", pressures.into())];
    panels(&all, Size::default(), Path::new("out/example-09"), "landing")?;
    println!("stands at {:.4} m; see out/example-09/landing.svg", column("trunk_body_z").last().unwrap_or(&f64::NAN));
    Ok(())
}
