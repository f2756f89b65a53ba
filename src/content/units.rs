//! The unit systems of sources.

/// A consistent system of units; time is in seconds, angles in radians.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnitSystem {
    /// Metre, kilogram, newton.
    Si,
    /// Foot, slug, pound-force.
    FootSlug,
}

/// One foot in metres, exactly.
const FOOT: f64 = 0.3048;
/// One pound-force in newtons: 0.45359237 kg × 9.80665 m/s², exactly.
const POUND_FORCE: f64 = 4.448_221_615_260_5;

impl UnitSystem {
    /// The systems by the name that a file gives them.
    pub const NAMES: [(&'static str, Self); 2] = [("SI", Self::Si), ("ft-slug-s", Self::FootSlug)];

    /// Its unit of length in metres.
    pub const fn length(self) -> f64 {
        match self {
            Self::Si => 1.0,
            Self::FootSlug => FOOT,
        }
    }

    /// Its unit of force in newtons.
    pub const fn force(self) -> f64 {
        match self {
            Self::Si => 1.0,
            Self::FootSlug => POUND_FORCE,
        }
    }

    /// Its unit of mass in kilograms: 1 slug = 1 lbf s²/ft.
    pub const fn mass(self) -> f64 {
        self.force() / self.length()
    }

    /// Its unit of moment of inertia in kg m².
    pub const fn inertia(self) -> f64 {
        self.force() * self.length()
    }

    /// Its unit of density in kg/m³.
    pub const fn density(self) -> f64 {
        self.mass() / (self.length() * self.length() * self.length())
    }
}
