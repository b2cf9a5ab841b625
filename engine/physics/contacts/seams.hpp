#pragma once

#include "physics/stages.hpp"

namespace plumb::physics {

/// Corrects contacts of bodies with several fixed shapes that abut: the edges between these are no border,
/// and neither a normal from one of them nor its points are valid. Part of updateContacts(). Reads:
/// work.contactFindings. Writes: contacts (points), work.endedAtSeams.
void correctSeams(StepContext& step);

/// Corrects a contact that was found for a hit, and lets a face that goes on in other fixed shapes touch as
/// one. Of what may be on its path, only what never yields has seams.
void touchUnion(StepContext& step, Contact& contact);

}  // namespace plumb::physics
