//! Demand from land use: people live, work, learn, shop and meet where buildings are for that.

use vc_graph::portable::Portable;
use vc_graph::{Seed, Stream};
use vc_map::{EntranceId, Point, StreetMap};

use super::demand::{Demand, DemandError, Errand, Outing, Resident, lines};

const BUILT_IN: &str = include_str!("../../data/land_use.txt");

/// One is chosen by how near it is, of so many places that fit and are drawn by their size.
const LOOKS_AT: usize = 12;
/// Places are chosen less the further they are: by a factor of e for so many metres.
const FAR: [(Errand, f32); 4] =
    [(Errand::Work, 4000.0), (Errand::School, 800.0), (Errand::Shop, 700.0), (Errand::Leisure, 1500.0)];
/// The share of a distance's journeys by car, of those who have one: below so many metres as the crow flies.
const BY_CAR: [(f32, f32); 4] = [(500.0, 0.05), (1000.0, 0.3), (2000.0, 0.7), (f32::INFINITY, 0.93)];
/// The shares of people who work and who go to school, and of cars among those who work and the others.
const WORKERS: f32 = 0.55;
const PUPILS: f32 = 0.17;
const CARS: [f32; 2] = [0.65, 0.5];
/// Everybody is on the way home by then, seconds since midnight.
const LATEST: f32 = 23.0 * HOUR;
const HOUR: f32 = 3600.0;

/// The use of buildings by their kind: how many people live, work and learn on 100 square metres of floor, and how much these draw others.
///
/// ```
/// use vc_traffic::LandUse;
/// // Nobody lives but in apartments, and all work in offices.
/// let own = LandUse::read("other 0 0 0 1 1\napartments 3 0 0 0 0\noffice 0 5 0 0 0")?;
/// assert_ne!(own, LandUse::default());
/// assert!(LandUse::read("office many").is_err_and(|error| error.line == 1));
/// # Ok::<(), vc_traffic::DemandError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct LandUse {
    rows: Vec<(String, [f32; 5])>,
}

impl Default for LandUse {
    /// The built-in table.
    fn default() -> Self {
        Self::read(BUILT_IN).unwrap_or(Self { rows: Vec::new() })
    }
}

impl LandUse {
    /// Land use as a table: a line each with the kind of a building and five numbers: homes, work, school, shops, leisure. The first is for kinds that are
    /// not there; `#` begins a comment.
    ///
    /// # Errors
    /// [`DemandError`]: the first line with too few or too many words, or a number that is none from 0 to 1,000.
    pub fn read(text: &str) -> Result<Self, DemandError> {
        let row = |(line, words): (usize, Vec<&str>)| {
            let numbers: Vec<f32> = words[1..].iter().filter_map(|word| word.parse().ok()).collect();
            let good = words.len() == 6 && numbers.iter().all(|number| (0.0..=1000.0).contains(number));
            let numbers = numbers.try_into().ok().filter(|_| good);
            let reason = || "give a kind and five numbers from 0 to 1,000".to_owned();
            Ok((words[0].to_owned(), numbers.ok_or_else(|| DemandError { line, reason: reason() })?))
        };
        Ok(Self { rows: lines(text).map(row).collect::<Result<_, _>>()? })
    }

    fn of(&self, kind: &str) -> [f32; 5] {
        let row = self.rows.iter().find(|(known, _)| known == kind).or(self.rows.first());
        row.map_or([0.0; 5], |(_, numbers)| *numbers)
    }
}

/// A door with what it draws, summed over those before it.
struct Places {
    doors: Vec<(EntranceId, Point)>,
    sums: Vec<f32>,
}

impl Places {
    fn draw(&self, numbers: &mut Stream) -> Option<(EntranceId, Point)> {
        let all = self.sums.last()?;
        let at = numbers.unit() * all;
        self.doors.get(self.sums.partition_point(|sum| *sum <= at)).copied()
    }
}

/// A city as those see it who look for a place in it.
struct City {
    /// By errand.
    places: [Places; 5],
}

impl City {
    fn new(map: &StreetMap, uses: &LandUse) -> Self {
        let mut places = [(); 5].map(|()| Places { doors: Vec::new(), sums: Vec::new() });
        let mut seen = vec![false; map.buildings().len()];
        for (number, door) in map.entrances().iter().enumerate() {
            let Some(building) = map.building(door.building).filter(|_| door.edge.is_some()) else { continue };
            if std::mem::replace(&mut seen[door.building.index()], true) {
                continue;
            }
            let floor = area(&building.outline) * f64::from(building.storeys.max(1));
            for (place, of) in places.iter_mut().zip(uses.of(&building.kind)) {
                let draws = of * floor as f32 / 100.0;
                if draws > 0.0 {
                    place.doors.push((EntranceId(number as u32), door.door));
                    place.sums.push(place.sums.last().unwrap_or(&0.0) + draws);
                }
            }
        }
        Self { places }
    }

    /// A place for an errand, not too far from another one.
    fn near(&self, errand: Errand, from: (EntranceId, Point), numbers: &mut Stream) -> Option<(EntranceId, Point)> {
        let far = FAR.iter().find(|(of, _)| *of == errand).map_or(1000.0, |(_, metres)| *metres);
        let places = &self.places[errand as usize];
        let drawn: Vec<_> = (0..LOOKS_AT).filter_map(|_| places.draw(numbers)).collect();
        let weight = |(door, at): &(EntranceId, Point)| match *door == from.0 {
            true => 0.0,
            false => (-apart(at, &from.1) / far).max(-80.0).exponential(),
        };
        drawn.get(numbers.weighted(drawn.iter().map(weight))?).copied()
    }
}

fn apart(a: &Point, b: &Point) -> f32 {
    (a - b).norm() as f32
}

fn area(ring: &[[f64; 2]]) -> f64 {
    let pairs = ring.iter().zip(ring.iter().cycle().skip(1));
    pairs.map(|(a, b)| a[0] * b[1] - b[0] * a[1]).sum::<f64>().abs() / 2.0
}

impl Demand {
    /// So many people who live where buildings are for that, with a week each: those who work or learn go there from Monday to Friday, and all shop and meet
    /// others. Places are chosen by their size and how near they are, and a car by those who have one, the more the further they go. Fewer
    /// people, with fewer journeys, where the map has no doors for them. Costs some microseconds for each person, and a look at each door.
    ///
    /// ```
    /// # use vc_graph::Seed;
    /// # use vc_map::{Building, BuildingId, Control, CrossSection, EntranceDraft, MapDraft, RoadClass, Strip};
    /// # use vc_traffic::{Demand, Errand, LandUse};
    /// # let mut draft = MapDraft::new("street", 48.1, 11.6);
    /// # let ends = [[0.0, 0.0], [900.0, 0.0]].map(|at| draft.junction(at, Control::Priority));
    /// # let side = vec![Strip::driving(3.0, 10.0), Strip::pavement(2.0)];
    /// # let section = CrossSection { forward: side.clone(), backward: side, median: 0.0 };
    /// # draft.road(ends[0], ends[1], RoadClass::Residential, section);
    /// # for (x, kind) in [(50.0, "house"), (450.0, "retail"), (850.0, "office")] {
    /// #     let mut building = Building::new(vec![[x, 6.0], [x + 9.0, 6.0], [x, 16.0]], 3);
    /// #     building.kind = kind.to_owned();
    /// #     draft.buildings.push(building);
    /// #     let building = BuildingId(draft.buildings.len() as u32 - 1);
    /// #     draft.entrances.push(EntranceDraft { building, at: [x, 6.0], kind: "main".into(), source: 0 });
    /// # }
    /// # let map = draft.build()?; // a street with a house, a shop and an office
    /// let demand = Demand::of_land_use(&map, &LandUse::default(), 100, Seed(7));
    /// assert!(demand.people.iter().all(|person| person.home.0 == 0));
    /// let work = demand.people.iter().flat_map(|person| &person.week).find(|outing| outing.to.0 == 2);
    /// assert_eq!(work.map(|outing| outing.errand), Some(Errand::Work));
    /// # Ok::<(), vc_map::MapError>(())
    /// ```
    pub fn of_land_use(map: &StreetMap, uses: &LandUse, people: usize, seed: Seed) -> Self {
        let city = City::new(map, uses);
        let people = (0..people as u64).filter_map(|number| resident(&city, seed.child("residents").nth(number)));
        Self { people: people.collect() }
    }
}

fn resident(city: &City, seed: Seed) -> Option<Resident> {
    let mut numbers = seed.stream();
    let home = city.places[Errand::Home as usize].draw(&mut numbers)?;
    let role = numbers.unit();
    let duty = match role {
        role if role < WORKERS => Some(Errand::Work),
        role if role < WORKERS + PUPILS => Some(Errand::School),
        _ => None,
    };
    let car = duty != Some(Errand::School) && numbers.chance(CARS[usize::from(duty.is_none())]);
    let place = duty.and_then(|duty| city.near(duty, home, &mut numbers));
    // Most errands are done at the same two places.
    let usual = [Errand::Shop, Errand::Shop, Errand::Leisure, Errand::Leisure]
        .map(|errand| city.near(errand, home, &mut numbers).map(|place| (errand, place)));
    let lunch = place.and_then(|place| city.near(Errand::Shop, place, &mut numbers));
    let mut week = Week { car, home, usual, outings: Vec::new(), day: 0, free: 0.0 };
    for day in 0..7 {
        (week.day, week.free) = (day, 0.0);
        let mut numbers = seed.child("days").nth(u64::from(day)).stream();
        match (duty, place) {
            (Some(duty), Some(place)) if day < 5 => week.on_duty(duty, place, lunch, &mut numbers),
            _ => week.at_leisure(&mut numbers),
        }
    }
    Some(Resident { home: home.0, car, week: week.outings })
}

/// A week that is put together.
struct Week {
    car: bool,
    home: (EntranceId, Point),
    usual: [Option<(Errand, (EntranceId, Point))>; 4],
    outings: Vec<Outing>,
    day: u8,
    /// Nothing begins before this time of the day, seconds.
    free: f32,
}

/// Where one goes on a round, for how long, seconds.
type Visit = (Errand, (EntranceId, Point), f32);

impl Week {
    /// A day with work or school, sometimes with a break outside, something on the way home, and an evening out.
    fn on_duty(
        &mut self,
        duty: Errand,
        place: (EntranceId, Point),
        lunch: Option<(EntranceId, Point)>,
        numbers: &mut Stream,
    ) {
        let (begins, lasts) = match duty {
            Errand::School => (numbers.normal(7.6, 0.2), numbers.normal(6.25, 0.6)),
            _ => (numbers.normal(7.7, 0.9), numbers.normal(8.5, 0.8)),
        };
        let lasts = lasts.max(2.0) * HOUR;
        let mut visits: Vec<Visit> = Vec::new();
        match lunch.filter(|_| duty == Errand::Work && numbers.chance(0.3)) {
            Some(shop) => visits.extend([
                (duty, place, lasts / 2.0),
                (Errand::Shop, shop, 0.6 * HOUR),
                (duty, place, lasts / 2.0),
            ]),
            None => visits.push((duty, place, lasts)),
        }
        if numbers.chance(0.3) {
            let shop = self.usual[numbers.below(2)];
            visits.extend(shop.map(|(errand, shop)| (errand, shop, numbers.between(0.2, 0.8) * HOUR)));
        }
        self.round(begins * HOUR, &visits, numbers);
        if numbers.chance(if duty == Errand::School { 0.5 } else { 0.3 }) {
            let begins = if duty == Errand::School { numbers.normal(16.0, 0.7) } else { numbers.normal(19.0, 0.7) };
            self.visit(begins, 2, 1.7, numbers);
        }
    }

    /// A day without.
    fn at_leisure(&mut self, numbers: &mut Stream) {
        if numbers.chance(0.75) {
            self.visit(numbers.normal(10.5, 1.3), 0, 0.7, numbers);
        }
        if numbers.chance(0.65) {
            self.visit(numbers.normal(15.0, 1.5), 2, 1.8, numbers);
        }
        if numbers.chance(0.15) {
            self.visit(numbers.normal(19.5, 0.7), 2, 2.0, numbers);
        }
    }

    /// A round to one of two usual places, for some hours.
    fn visit(&mut self, begins: f32, first: usize, hours: f32, numbers: &mut Stream) {
        let Some((errand, place)) = self.usual[first + numbers.below(2)] else { return };
        self.round(begins * HOUR, &[(errand, place, hours * numbers.between(0.6, 1.4) * HOUR)], numbers);
    }

    /// A round from home and back: all of it by car, or all on foot, but that one walks from work to lunch and back.
    fn round(&mut self, begins: f32, visits: &[Visit], numbers: &mut Stream) {
        let far = visits.iter().map(|(_, (_, at), _)| apart(at, &self.home.1)).fold(0.0, f32::max);
        let share = BY_CAR.iter().find(|(metres, _)| far < *metres).map_or(0.0, |(_, share)| *share);
        let by_car = self.car && numbers.chance(share);
        let mut time = begins.max(self.free);
        if time > LATEST - HOUR {
            return;
        }
        let lunch = visits.len() > 2 && visits[0].1.0 == visits[2].1.0;
        for (number, (errand, (to, _), lasts)) in visits.iter().enumerate() {
            let by_car = by_car && !(lunch && (number == 1 || number == 2));
            self.go(time, *to, *errand, by_car);
            // A guess of the way, so that one stays as long as one means to.
            time = (time + lasts + 600.0).min(LATEST);
        }
        self.go(time, self.home.0, Errand::Home, by_car);
        self.free = (time + 0.5 * HOUR).min(LATEST);
    }

    fn go(&mut self, time: f32, to: EntranceId, errand: Errand, by_car: bool) {
        self.outings.push(Outing { day: self.day, leaves: time.max(0.0) as u32, to, errand, by_car });
    }
}
