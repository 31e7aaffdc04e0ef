//! The robots with the kernel of derivatives, which is made on request, as declarations of their own.

use std::path::Path;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let (declared, made) = (Path::new("../declared"), std::env::var("OUT_DIR")?);
    for robot in ["ur5", "talosarm", "panda", "anymal", "talos"] {
        let path = declared.join(format!("{robot}.rs"));
        println!("cargo::rerun-if-changed={}", path.display());
        let text = std::fs::read_to_string(path)?;
        let (before, kernels) = text.split_once("    kernels {").ok_or("no block `kernels`")?;
        let (_, rest) = kernels.split_once('}').ok_or("no end of the block `kernels`")?;
        std::fs::write(
            Path::new(&made).join(format!("{robot}.rs")),
            format!("{before}    kernels {{ dynamics_jacobian; }}{rest}"),
        )?;
    }
    Ok(())
}
