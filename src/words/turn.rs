//! Axes and angles, each in a sentence with its right-hand rule, and the controls that turn the aircraft by hand.

/// The button that turns it by hand.
pub const BUTTON: &str = "Turn";

/// The same in words.
pub const BUTTON_IN_WORDS: &str = "Turn the aircraft by hand";

/// What it does.
pub const HINT: &str =
    "Turn the aircraft about its axes by hand, instead of flying. The responses stay as they are";

/// On the picture.
pub const NOTE: &str = "Turned by hand: first ψ, then θ, then φ";

/// Back to no angle.
pub const RESET: &str = "Back to level flight to the north";

/// What can be explained, in the order of the page.
pub const EXPLAINED: [&str; 9] = ["x", "y", "z", "x_E", "y_E", "z_E", "ψ", "θ", "φ"];

/// The angles in the order in which they turn, for sliders: symbol, and name with the order.
pub const ANGLES: [(&str, &str); 3] =
    [("ψ", "First: heading ψ"), ("θ", "Second: pitch θ"), ("φ", "Third: bank φ")];

/// A body axis as it is drawn: what turns about it.
pub const fn about(axis: usize) -> (&'static str, &'static str) {
    match axis {
        0 => ("x: φ, p", "roll"),
        1 => ("y: θ, q", "pitch"),
        _ => ("z: ψ, r", "yaw"),
    }
}

/// Which angle the label of an angle or its axis is of: ψ, θ and φ are 0, 1 and 2.
pub fn angle(symbol: &str) -> Option<usize> {
    match symbol {
        "ψ" | "z: ψ, r" => Some(0),
        "θ" | "y: θ, q" => Some(1),
        "φ" | "x: φ, p" => Some(2),
        _ => None,
    }
}

/// What a symbol on the picture means; `None` for what has no direction of its own.
pub fn sentence(symbol: &str) -> Option<&'static str> {
    Some(match symbol {
        "x" | "x: φ, p" => {
            "x points forward, out of the nose. To turn about it is to roll: angle φ, rate p, positive as the right wing goes \
             down. Right hand: the thumb along x, the fingers curl from y to z."
        }
        "y" | "y: θ, q" => {
            "y points to the right, along the right wing. To turn about it is to pitch: angle θ, rate q, positive as the nose goes \
             up. Right hand: the thumb along y, the fingers curl from z to x."
        }
        "z" | "z: ψ, r" => {
            "z points down, through the floor. To turn about it is to yaw: angle ψ, rate r, positive as the nose goes right. Right \
             hand: the thumb along z, the fingers curl from x to y."
        }
        "x_E" => {
            "x_E lies level, along the undisturbed flight, and stays with the Earth. Heading ψ is counted from it."
        }
        "y_E" => "y_E lies level, to the right of x_E, and stays with the Earth.",
        "z_E" => {
            "z_E points straight down, as weight does, and stays with the Earth. Heading ψ turns about it."
        }
        "ψ" => {
            "ψ, heading, turns first: about z_E, from x_E, positive to the right. It takes the x axis to where the aircraft heads."
        }
        "θ" => {
            "θ, pitch, turns second: about the y axis as ψ has left it, which is still level, positive nose-up, 90° at most. It \
             lifts x above the horizon."
        }
        "φ" => {
            "φ, bank, turns third: about the body's own x axis, positive right wing down. It takes the wings out of the level."
        }
        "p" => "p, roll rate, is how fast it turns about its x axis, positive right wing down.",
        "q" => "q, pitch rate, is how fast it turns about its y axis, positive nose-up.",
        "r" => "r, yaw rate, is how fast it turns about its z axis, positive nose right.",
        "α" => {
            "α, angle of attack, lies between x and the flight in the plane of symmetry, positive as the air comes from below."
        }
        "β" => {
            "β, sideslip, lies between the plane of symmetry and the flight, positive as the air comes from the right."
        }
        "V" => "V is the velocity: where the aircraft flies, which is seldom where it points.",
        "x_s" => {
            "x_s, y and z_s are stability axes: the body axes turned about y by the angle of attack of the steady flight, so that \
             x_s lies along it. They stay with the body."
        }
        "z_s" => {
            "z_s is the z axis of stability axes: across the steady flight, downward, in the plane of symmetry."
        }
        _ => return None,
    })
}
