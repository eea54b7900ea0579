//! Vehicles: cars, lorries, two-wheelers and boats.

mod boat;
mod bus;
mod car;
mod chassis;
mod cycle;
mod small;
mod truck;
pub(super) mod wheel;

use super::{Generator, outdoor};

pub(super) const GENERATORS: &[Generator] = &[
    outdoor("car", 40, car::car),
    outdoor("sedan", 25, car::car),
    outdoor("hatchback", 25, car::car),
    outdoor("station_wagon", 20, car::car),
    outdoor("suv", 20, car::car),
    outdoor("sports_car", 15, car::car),
    outdoor("convertible", 15, car::car),
    outdoor("electric_car", 15, car::car),
    outdoor("pickup", 15, car::car),
    outdoor("minivan", 15, car::car),
    outdoor("taxi", 10, car::car),
    outdoor("police_car", 10, car::car),
    outdoor("van", 15, car::car),
    outdoor("ambulance", 8, car::car),
    outdoor("camper_van", 10, bus::camper_van),
    outdoor("truck", 15, truck::truck),
    outdoor("garbage_truck", 8, truck::garbage_truck),
    outdoor("fire_truck", 8, truck::fire_truck),
    outdoor("bus", 10, bus::bus),
    outdoor("motorcycle", 15, cycle::motorcycle),
    outdoor("scooter", 10, cycle::scooter),
    outdoor("quad_bike", 8, small::quad_bike),
    outdoor("golf_cart", 8, small::golf_cart),
    outdoor("electric_scooter", 8, cycle::electric_scooter),
    outdoor("bicycle", 25, cycle::bicycle),
    outdoor("electric_bicycle", 10, cycle::bicycle),
    outdoor("cargo_bike", 10, cycle::bicycle),
    outdoor("rowing_boat", 8, boat::rowing_boat),
    outdoor("kayak", 8, boat::kayak),
    outdoor("motorboat", 8, boat::motorboat),
    outdoor("car_trailer", 10, small::car_trailer),
];
