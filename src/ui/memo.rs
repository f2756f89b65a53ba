//! What follows from the scenario on screen, computed again only when the scenario has changed. Only pictures are held elsewhere:
//! curves, triangles and shapes, each beside what it was made of (`kept`).

use crate::flight::aircraft::coefficients::Coefficients;
use crate::flight::analysis::{Motion, PlaneAnalysis};
use crate::flight::modes::locus::Locus;
use crate::flight::motion::flight_path::FlightPath;
use crate::flight::motion::six_dof::SixDofError;
use crate::flight::{Analysis, AnalysisError};
use crate::scenario::{Disturbance, Page, Parameter, RowSensitivity, Scenario};

/// A scenario and what follows from it.
#[derive(Debug, Default)]
pub struct Memo {
    of: Option<(Scenario, Page, Followed)>,
    locus: Option<(Scenario, &'static str, Locus)>,
    flight: Option<(Scenario, Result<FlightPath, SixDofError>)>,
    computations: u64,
}

/// What follows from a scenario.
#[derive(Debug)]
pub struct Followed {
    /// The analysis of both planes.
    pub analysis: Result<Analysis, AnalysisError>,
    /// How every slider of the page on screen moves the modes of the plane on screen.
    pub sensitivities: Vec<RowSensitivity>,
    /// The coefficients as knobs and flight condition make them, where the aircraft has any.
    pub coefficients: Option<Coefficients>,
}

impl Followed {
    fn of(scenario: &Scenario, page: Page) -> Self {
        let analysis = scenario.analyse();
        let plane = analysis
            .as_ref()
            .ok()
            .and_then(|analysis| analysis.planes[scenario.plane].as_ref()?.as_ref().ok());
        let sensitivities = plane.map_or_else(Vec::new, |plane| scenario.sensitivities(plane, page));
        Self { analysis, sensitivities, coefficients: scenario.coefficients_in_effect() }
    }
}

impl Memo {
    /// Computes again if `scenario` or `page` is not that of the last time, and gives what follows.
    pub fn refresh(&mut self, scenario: &Scenario, page: Page) -> &Followed {
        if !self.is_of(scenario, page) {
            self.of = None;
        }
        let computations = &mut self.computations;
        let (_, _, followed) = self.of.get_or_insert_with(|| {
            *computations += 1;
            (scenario.clone(), page, Followed::of(scenario, page))
        });
        followed
    }

    /// Whether what it holds follows from `scenario`.
    pub fn is_of(&self, scenario: &Scenario, page: Page) -> bool {
        self.of.as_ref().is_some_and(|(of, on, _)| of == scenario && *on == page)
    }

    /// The scenario of the last refresh.
    pub fn scenario(&self) -> Option<&Scenario> {
        self.of.as_ref().map(|(scenario, _, _)| scenario)
    }

    /// What followed at the last refresh.
    pub fn followed(&self) -> Option<&Followed> {
        self.of.as_ref().map(|(_, _, followed)| followed)
    }

    /// What followed for the plane on screen, where all went well.
    pub fn plane(&self) -> Option<&PlaneAnalysis> {
        let (scenario, _, followed) = self.of.as_ref()?;
        followed.analysis.as_ref().ok()?.planes[scenario.plane].as_ref()?.as_ref().ok()
    }

    /// The motion that followed, where there is one.
    pub fn motion(&self) -> Option<&Motion> {
        self.followed()?.analysis.as_ref().ok()?.motion.as_ref()
    }

    /// Finds the path along which a parameter would send the poles of `scenario`, unless it is the one that is held.
    pub fn refresh_locus(&mut self, scenario: &Scenario, parameter: Option<&'static Parameter>) {
        let Some(parameter) = parameter else {
            self.locus = None;
            return;
        };
        // The path doesn't depend on how far along it the parameter is.
        let mut start = scenario.clone();
        parameter.reset(&mut start);
        start.disturbance = Disturbance::default();
        if !self.locus.as_ref().is_some_and(|(of, key, _)| *of == start && *key == parameter.key) {
            let locus = start.locus(parameter);
            self.locus = Some((start, parameter.key, locus));
        }
    }

    /// Flies the nonlinear equations through the scenario of the last refresh, unless that is the flight that is held.
    pub fn refresh_flight(&mut self) {
        let Some((scenario, _, _)) = &self.of else { return };
        if self.flight.as_ref().is_some_and(|(of, _)| of == scenario) {
            return;
        }
        self.flight = self.plane().map(|plane| (scenario.clone(), scenario.fly(plane)));
    }

    /// The nonlinear flight, if it is that of the scenario of the last refresh.
    pub fn flight(&self) -> Option<&Result<FlightPath, SixDofError>> {
        let (scenario, _, _) = self.of.as_ref()?;
        self.flight.as_ref().filter(|(of, _)| of == scenario).map(|(_, flight)| flight)
    }

    /// The path found last.
    pub fn locus(&self) -> Option<&Locus> {
        self.locus.as_ref().map(|(_, _, locus)| locus)
    }

    /// How often it has analysed, so that tests can see that nothing is computed twice.
    pub fn computations(&self) -> u64 {
        self.computations
    }
}
