//! The blocks of a declaration, line by line.

/// Blocks in the order in which they are written, with their lines.
#[derive(Default)]
pub(super) struct Blocks {
    lines: Vec<(&'static str, String)>,
}

/// Free bodies stand before the frames on them, the others after the frames that they are on.
const ORDER: [&str; 14] = [
    "parameters",
    "coordinates",
    "inputs",
    FREE,
    "frames",
    "bodies",
    "loads",
    "constraints",
    "initial",
    "events",
    "outputs_angles",
    "outputs_lengths",
    "drawing",
    "kernels",
];

/// The block of bodies that are free.
pub(super) const FREE: &str = "free bodies";

impl Blocks {
    /// Adds a line to a block.
    pub(super) fn line(&mut self, block: &'static str, line: String) {
        self.lines.push((block, line));
    }

    /// All of them.
    pub(super) fn text(&self) -> String {
        let mut text = String::new();
        for block in ORDER {
            let lines: Vec<&str> =
                self.lines.iter().filter(|(of, _)| *of == block).map(|(_, line)| line.as_str()).collect();
            if lines.is_empty() {
                continue;
            }
            let [open, close] = match block {
                FREE => ["bodies {", "}"],
                "outputs_angles" => ["outputs { margins \"Angles to the limits\" {", "} }"],
                "outputs_lengths" => ["outputs { margins_of_slides \"Ways to the limits\" {", "} }"],
                _ => ["", "}"],
            };
            let open = if open.is_empty() { format!("{block} {{") } else { open.to_owned() };
            text += &format!("\n{open}\n");
            lines.iter().for_each(|line| text += &format!("    {line}\n"));
            text += close;
            text += "\n";
        }
        text
    }
}
