/*---------------------------------------------------------------------------*\
    demRotatingFrame.C -- zones of cells in a rotating frame (MRF).

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demRotatingFrame.H"
#include "demFiles.H"
#include "demPassable.H"
#include "emptyPolyPatch.H"
#include "Constant.H"
#include "SubField.H"
#include "IOdictionary.H"
#include "Time.H"

namespace Foam
{
    // Sine of the largest angle between the velocity of a surface of revolution and its
    // faces: at the ends of chords of a circle of 16 faces it is half of this
    static const scalar maxLean = 0.2;
}


Foam::demRotatingFrame::demRotatingFrame
(
    const polyMesh& mesh,
    const word& name,
    const dictionary& dict
)
:
    mesh_(mesh),
    name_(name),
    zone_(dict.get<word>("cellZone")),
    origin_(dict.get<vector>("origin")),
    axis_(normalised(dict.get<vector>("axis"))),
    speed_(0),
    excluded_(dict.getOrDefault<wordRes>("nonRotatingPatches", wordRes()))
{
    const autoPtr<Function1<scalar>> omega(Function1<scalar>::New("omega", dict));
    if (!isA<Function1Types::Constant<scalar>>(omega()))
    {
        FatalIOErrorInFunction(dict)
            << "omega of zone " << name_ << " changes in time, but walls of the particles"
            << " rotate at a constant speed; give a number, or let the mesh rotate"
            << exit(FatalIOError);
    }
    speed_ = omega->value(mesh.time().value());
}


Foam::PtrList<Foam::demRotatingFrame> Foam::demRotatingFrame::all(const polyMesh& mesh)
{
    const IOdictionary dict
    (
        demFileAt(mesh.time().constant(), "MRFProperties", mesh, IOobject::READ_IF_PRESENT)
    );
    PtrList<demRotatingFrame> frames;

    for (const entry& zone : dict)
    {
        if (zone.isDict() && zone.dict().getOrDefault("active", true))
        {
            frames.append(new demRotatingFrame(mesh, zone.keyword(), zone.dict()));
        }
    }
    return frames;
}


void Foam::demRotatingFrame::check(const polyMesh& mesh, const bool volumeAveraged)
{
    if (mesh.foundObject<IOdictionary>("SRFProperties"))
    {
        FatalErrorInFunction
            << "This solver's velocity is relative to a rotating frame"
            << " (constant/SRFProperties), but particles need the absolute one; take a mesh"
            << " that rotates, or MRF" << exit(FatalError);
    }

    const PtrList<demRotatingFrame> frames(all(mesh));
    if (volumeAveraged && frames.size())
    {
        FatalErrorInFunction
            << "Zone " << frames[0].name_ << " of constant/MRFProperties is active, but"
            << " demPimpleFoam and demInterFoam have no rotating frames; let the mesh rotate"
            << " (cyclicAMI), or set active no" << exit(FatalError);
    }
}


const Foam::labelUList& Foam::demRotatingFrame::cells() const
{
    const label zone = mesh_.cellZones().findZoneID(zone_);

    return zone < 0 ? labelUList::null() : mesh_.cellZones()[zone];
}


bool Foam::demRotatingFrame::rotates(const polyPatch& patch) const
{
    if (demPassable::is(patch) || isA<emptyPolyPatch>(patch) || excluded_.match(patch.name()))
    {
        return false;
    }

    const label zone = mesh_.cellZones().findZoneID(zone_);
    label inside = 0;
    for (const label celli : patch.faceCells())
    {
        inside += zone >= 0 && mesh_.cellZones()[zone].localID(celli) >= 0;
    }
    const label faces = returnReduce(patch.size(), sumOp<label>());
    reduce(inside, sumOp<label>());

    if (inside && inside < faces)
    {
        FatalErrorInFunction
            << inside << " of the " << faces << " faces of patch " << patch.name()
            << " lie in zone " << name_ << " of constant/MRFProperties, but a wall of the"
            << " particles has one rotation; make it two patches, or list it in"
            << " nonRotatingPatches" << exit(FatalError);
    }
    return inside > 0;
}


void Foam::demRotatingFrame::checkWall(const polyPatch& patch) const
{
    scalar lean = 0;
    forAll(patch, i)
    {
        const vector v(velocity(patch.faceCentres()[i]));
        const vector& S = patch.faceAreas()[i];
        lean = max(lean, mag(v & S)/max(mag(v)*mag(S), VSMALL));
    }

    if (returnReduce(lean, maxOp<scalar>()) > maxLean)
    {
        FatalErrorInFunction
            << "Patch " << patch.name() << " rotates with zone " << name_ << " of"
            << " constant/MRFProperties and is no surface of revolution: it would push the"
            << " particles while it stands still; let the mesh rotate (cyclicAMI), list it in"
            << " nonRotatingPatches, or give its surfaceVelocity or surfaceRotation in walls/"
            << patch.name() << exit(FatalError);
    }
}


Foam::dictionary Foam::demRotatingFrame::surfaceRotation() const
{
    dictionary rotation;

    rotation.add("origin", origin_);
    rotation.add("axis", axis_);
    rotation.add("omega", speed_);
    return rotation;
}
