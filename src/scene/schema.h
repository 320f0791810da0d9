// Every key of a scene file, once: its name, field, unit, accepted range, an example and what it means. The reader, the
// canonical writer, `furrow keys` and the JSON Schema of scenes all walk these functions, so a key cannot be known to
// one of them and not to another. The default is that of the struct in scene.h.
//
// A visitor is called as  v(name, field, key)  for a key that may be left out (the struct's default holds),
// v.required(name, field, key)  for one that may not, and
// v.choice(name, field, {{"word", value, meaning}, ...}, meaning)  for an enum,
// v.follows(name, other)  for a key whose value follows from another key that is given: it must be left out.
#pragma once

#include "scene/schema_parts.h"

namespace furrow {

void describe(auto& v, Model& m) {
  v("gravity", m.gravity, {"m/s^2", finite, "1.62", "Acceleration of free fall, along -y."});
  v.choice("disc_mass", m.disc_mass,
           {{"disc", DiscMass::disc, "cylinders: m = rho pi R^2 b, I = m R^2 / 2"},
            {"sphere", DiscMass::sphere, "spheres: m = 4/3 pi rho R^3, I = 2/5 m R^2"}},
           "The body whose mass and moment of inertia a disc has.");
  v("disc_depth", m.disc_depth,
    {"m", positive, "0.5", "Length b of the cylinders; without effect where disc_mass is sphere."});
  v.choice("moment_arm", m.moment_arm,
           {{"contact_point", MomentArm::contact_point, "to the contact point, between the two surfaces"},
            {"half_overlap", MomentArm::half_overlap, "R - d/2, on walls too, as in LIGGGHTS"},
            {"radius", MomentArm::radius, "the whole radius"}},
           "Moment arm of the tangential force.");
  v.choice("law", m.law,
           {{"hertz_mindlin", ForceLaw::hertz_mindlin, "Hertz's normal force, Mindlin's tangential stiffness"},
            {"rescaled_mindlin", ForceLaw::rescaled_mindlin,
             "the same, and the tangential force shrinks with the contact as it unloads (Thornton)"},
            {"linear", ForceLaw::linear, "springs of constant stiffness (Cundall and Strack)"}},
           "The law of contact forces.");
  v("slip_damping", m.slip_damping, plain("false", "Whether the tangential force of a contact is damped too."));
  v.choice(
      "after_slip", m.after_slip,
      {{"elastic", AfterSlip::elastic, "the Coulomb limit"},
       {"less_viscous", AfterSlip::less_viscous,
        "the Coulomb limit less the viscous force, as in LAMMPS; the energy ledger closes by the linear law alone"}},
      "What a tangential spring holds after it has slipped.");
  v.choice("rolling", m.rolling,
           {{"smoothed", Rolling::smoothed, "a moment that fades below rolling_smoothing: it slows, but holds nothing"},
            {"spring", Rolling::spring, "a spring up to the limit (Ai et al. 2011, type C): discs can rest on a slope"},
            {"none", Rolling::none, "no moment, whatever rolling_friction says"}},
           "How rolling is resisted.");
  v("pull", m.pull,
    plain("true", "Whether the viscous force of a contact may exceed the elastic one, so that the contact pulls."));
  v("tight_plates", m.tight_plates,
    plain(
        "true",
        "Whether a disc or node keeps the face of a plate that it met, however deep it is pressed, and whether plates "
        "that are flush with each other, or stand on a wall, are one surface. Left out: no."));
  v("new_faces", m.new_faces,
    plain("true",
          "Whether a lattice that tears has new faces: the cells next to a torn link are open, and discs touch what "
          "bounds them. Left out: no."));
  v("rolling_smoothing", m.rolling_smoothing,
    {"rad/s", positive, "0.5",
     "Relative spin w0 below which rolling friction fades, by w / sqrt(w^2 + w0^2). Smaller values need smaller "
     "steps."});
}

void describe(auto& v, Timing& t) {
  v.required("end", t.end, {"s", positive, "1.2", "End of the run; it begins at 0, when the scene has settled."});
  v.required("step", t.step,
             {"s", positive, "1e-4", "The time step; of a method that controls its step the first one that it tries."});
  v("method", t.method, plain("\"verlet\"", "The integration method; `furrow methods` lists them."));
  v("relative_tolerance", t.relative_tolerance,
    {"-", Range{1e-14, 0.1}, "1e-8", "Error of a step, of the state. For methods that control their step."});
  v("absolute_tolerance", t.absolute_tolerance,
    {"m, m/s, rad/s", Range{1e-18, 1}, "1e-12", "Error of a step. For methods that control their step."});
  v("max_step", t.max_step, {"s", positive, "1e-4", "Longest step of a method that controls its step."});
  v.choice("locate", t.locate,
           {{"none", Locate::none, "a tear is noticed at the end of its step, as in the paper"},
            {"tears", Locate::tears, "a step ends where a link tears"},
            {"all", Locate::all, "and where a contact begins, ends or slips: for scenes with few contacts"}},
           "Events at which a step ends.");
  v.choice("solver", t.solver,
           {{"kernel", SolverKind::kernel, "the fast one"},
            {"reference", SolverKind::reference, "the one that is there to be read; many times slower"}},
           "The solver. Both give the same bits.");
}

void describe(auto& v, Search& s) {
  v("skin", s.skin,
    {"m", not_negative, "0.002",
     "Added to the reach of the neighbour list, which is then built less often. 0: chosen from the radii."});
  v("cell_size", s.cell_size,
    {"m", not_negative, "0.05", "Side of a search cell. 0: the reach of the neighbour list."});
  v("threads", s.threads, {"", Range{1, 64}, "2", "Threads in one step, for beds of more than 4096 discs."});
}

void describe(auto& v, Settle& s) {
  v("speed", s.speed,
    {"m/s", positive, "1e-3", "The scene has settled when for the time `hold` no disc and no node was faster."});
  v("hold", s.hold, {"s", not_negative, "0.2", "How long everything must be slow."});
  v("step", s.step, {"s", positive, "5e-5", "Time step of the settling. Left out: time.step."});
  v("limit", s.limit, {"s", positive, "40.0", "A scene that has not settled by then is an error."});
  v("loose", s.loose,
    {"-", Range{0, 1, false, true}, "0.001",
     "Share of discs and nodes that may be faster: of very many some always are. Left out: none."});
}

void describe(auto& v, Output& o) {
  v("interval", o.interval,
    {"s", positive, "0.01",
     "Time between rows of plate_force.csv, wall_force.csv, energy.csv and motion.csv; at least time.step."});
  v("frames", o.frames,
    {"s", not_negative, "[0.0, 0.5]", "Times of the pictures in frames/, each later than the one before it."});
  v("energy", o.energy, plain("false", "Whether the energy ledger is kept and watched."));
  v("angles", o.angles, plain("true", "Whether frames tell how far each disc has turned: one more number a disc."));
  v("checkpoint", o.checkpoint,
    {"s", positive, "0.1",
     "Model time between checkpoints, from which a run can be resumed. Left out: at the start and at the end."});
}

void describe(auto& v, Allow& a) {
  v("energy_made", a.energy_made,
    {"-", positive, "0.2",
     "Energy that the method or a law has made, of all that the scene was given: the residual of the ledger, heat "
     "that was taken back, or what there is beyond what was given."});
  v("energy_lost", a.energy_lost, {"-", positive, "0.5", "Energy that is missing in the ledger, of the same."});
  v("overlap", a.overlap, {"-", positive, "0.5", "Greatest overlap, of the smaller radius."});
  v("step", a.step, {"-", positive, "0.8", "Time step, of the largest stable one."});
  v("behind_walls", a.behind_walls, plain("true", "Whether centres of discs may be behind a wall."));
  v("through_plates", a.through_plates, plain("true", "Whether centres may cross the middle of a plate."));
  v("through_lattices", a.through_lattices, plain("true", "Whether centres may cross the border of a lattice."));
  v("crossing_lattices", a.crossing_lattices,
    plain("true",
          "Whether lattices may cross each other or themselves, cells turn inside out, plates go through a lattice, "
          "and bodies through a torn border. Left out: no."));
}

void describe(auto& v, Scene& s) {
  v.required("title", s.title, plain("\"A disc falls on a floor\"", "What happens, in one sentence."));
  v("model", s.model, table("Gravity, and how the open points of the model are read."));
  v.required("time", s.time, table("When the run ends, and how it is integrated."));
  v("search", s.search, table("The search for contacts. It changes the time of a run, not its bits."));
  v("contact", s.contact, table("Damping and friction of all contacts."));
  v("material", s.material,
    table("Elastic constants and density, under a name. Young's modulus and one of poisson and shear are required "
          "unless it is rigid."));
  v("disc", s.disc, table("One disc."));
  v("packing", s.packing,
    table("Discs placed at random in a rectangle, without overlap. Their radii are uniform between the two limits."));
  v("settle", s.settle,
    table("Before t = 0 the scene runs with plates at rest and links that do not tear, until everything is slow."));
  v("wall", s.wall, table("A fixed half-plane that discs and nodes stay out of."));
  v("plate", s.plate, table("A rigid rectangle that moves with a constant velocity."));
  v("lattice", s.lattice,
    table(
        "Rows by columns of point masses joined by springs and dampers; row 0 is the lowest, column 0 the leftmost."));
  v("output", s.output, table("What is written, and how often."));
  v("allow", s.allow,
    table("What this scene is known to do beyond the validity of its laws. Up to there it neither warns nor ends."));
}

}  // namespace furrow
