/*---------------------------------------------------------------------------*\
    demWriter.C -- writes particles as a lagrangian cloud.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demWriter.H"
#include "demColumns.H"
#include "demRankBuffers.H"
#include "IOdictionary.H"
#include "IOField.H"
#include "Time.H"
#include "DynamicList.H"
#include <cmath>

namespace Foam
{

static const fileName cloudFolder("lagrangian/particles");

// One particle as numbers, sent to the rank that writes it:
// 0 cell, 1 position, 4 velocity, 7 spin, 10 contact force, 13 diameter,
// 14 mass, 15 id, 16 material, 17 flags, 18 true position, 21 first of the scalars
enum { N_NUMBERS = 21 };

// Numbers of the particle scalars that are written
static labelList writtenScalars(const ::dem* d)
{
    DynamicList<label> written;

    for (int k = 0; k < dem_scalar_count(d); k++)
    {
        struct ::dem_scalar_info info;
        dem_scalar_info(d, k, &info);
        if (info.written)
        {
            written.append(k);
        }
    }
    return labelList(written);
}


static void pack
(
    ::dem* d,
    const labelUList& scalars,
    const struct ::dem_view& v,
    const struct ::dem_view& folded,
    const double* address,
    const point& corner,
    const size_t i,
    DynamicList<scalar>& to
)
{
    const double* x = dem_at(folded.position, folded.stride, i);
    const double* truePosition = dem_at(v.position, v.stride, i);
    const double* u = dem_at(v.velocity, v.stride, i);
    const double* w = dem_at(v.spin, v.stride, i);

    to.append(address[2*i + 1]);
    for (int k = 0; k < 3; k++)
    {
        // Readers look for it inside the mesh; within a skin of a periodic face it may be outside
        const scalar L = v.period[k];
        to.append(L > 0 ? x[k] - L*std::floor((x[k] - corner[k])/L) : x[k]);
    }
    for (int k = 0; k < 3; k++) to.append(u[k]);
    for (int k = 0; k < 3; k++) to.append(w[k]);
    for (int k = 0; k < 3; k++) to.append(v.force[3*i + k]);
    to.append(2*(*dem_at(v.radius, v.stride, i)));
    to.append(*dem_at(v.mass, v.stride, i));

    to.append(scalar(idOf(v, label(i))));       // exact, see maxId
    const char* at = reinterpret_cast<const char*>(v.material) + v.stride*i;
    to.append(*reinterpret_cast<const uint16_t*>(at));
    at = reinterpret_cast<const char*>(v.flags) + v.stride*i;
    to.append(*reinterpret_cast<const uint16_t*>(at));

    for (int k = 0; k < 3; k++) to.append(truePosition[k]);
    for (const label k : scalars) to.append(dem_scalar(d, k)[i]);
}


// Send each particle to the rank of its cell
static List<scalar> distribute
(
    ::dem* d,
    const labelUList& scalars,
    const struct ::dem_view& v,
    const struct ::dem_view& folded,
    const double* address,
    const point& corner
)
{
    demRankBuffers out(Pstream::nProcs()), in(Pstream::nProcs());

    for (size_t i = 0; i < v.n; i++)
    {
        pack(d, scalars, v, folded, address, corner, i, out[label(address[2*i])]);
    }
    demExchangeBuffers(out, in);

    DynamicList<scalar> all;
    for (const DynamicList<scalar>& message : in)
    {
        all.append(message);
    }
    return List<scalar>(all);
}


static inline vector three(const UList<scalar>& numbers, const label at)
{
    return vector(numbers[at], numbers[at + 1], numbers[at + 2]);
}


// The note of every file names the active effects, as in the fields
static IOobject fileOf
(
    const fvMesh& mesh,
    const word& name,
    const string& heading,
    const fileName& folder = cloudFolder
)
{
    IOobject io
    (
        name,
        mesh.time().timeName(),
        folder,
        mesh,
        IOobject::NO_READ,
        IOobject::NO_WRITE,
        false
    );
    io.note() = heading;
    return io;
}


// The file `positions`, as an object so that the file handler writes it
class positionsFile
:
    public regIOobject
{
    const UList<scalar>& all_;
    const label each_;


public:

    positionsFile(const IOobject& io, const UList<scalar>& all, const label each)
    :
        regIOobject(io),
        all_(all),
        each_(each)
    {}

    virtual const word& type() const
    {
        static const word name("Cloud<passiveParticle>", false);
        return name;
    }

    virtual bool writeData(Ostream& os) const
    {
        const int before = os.precision(15);

        os  << all_.size()/each_ << nl << "(" << nl;
        for (label at = 0; at < all_.size(); at += each_)
        {
            os  << three(all_, at + 1) << ' ' << label(all_[at]) << nl;
        }
        os  << ")" << nl;
        os.precision(before);
        return !os.bad();
    }
};


// Without this file readers expect barycentric coordinates
static void writeProperties(const fvMesh& mesh, const string& heading)
{
    IOdictionary properties
    (
        fileOf(mesh, "cloudProperties", heading, fileName("uniform")/cloudFolder)
    );
    properties.add("geometry", word("positions"));
    demWriteAscii(properties);
}


template<class Type, class From>
static void writeField
(
    const IOobject& io,
    const UList<scalar>& all,
    const label each,
    const label first,
    const From& from
)
{
    IOField<Type> field(io, all.size()/each);

    forAll(field, i)
    {
        field[i] = from(all, each*i + first);
    }
    field.write();
}

} // End namespace Foam


// A label of OpenFOAM, passed between ranks as a double
int64_t Foam::demWriter::maxId()
{
    return min(int64_t(labelMax), int64_t(1) << 53);
}


void Foam::demWriter::write
(
    const fvMesh& mesh,
    ::dem* d,
    const struct ::dem_view& view,
    const struct ::dem_view& folded,
    const double* address,
    const string& heading
)
{
    const labelList scalars(writtenScalars(d));
    const label each = N_NUMBERS + scalars.size();
    const List<scalar> all(distribute(d, scalars, view, folded, address, mesh.bounds().min()));

    const auto one = [](const UList<scalar>& n, const label at)
    {
        return n[at];
    };
    const auto whole = [](const UList<scalar>& n, const label at)
    {
        return label(n[at]);
    };

    const auto io = [&](const word& name)
    {
        return fileOf(mesh, name, heading);
    };

    demWriteAscii(positionsFile(io("positions"), all, each));
    writeProperties(mesh, heading);
    writeField<vector>(io("U"), all, each, 4, three);
    writeField<vector>(io("omega"), all, each, 7, three);
    writeField<vector>(io("contactForce"), all, each, 10, three);
    writeField<scalar>(io("d"), all, each, 13, one);
    writeField<scalar>(io("mass"), all, each, 14, one);
    writeField<label>(io("id"), all, each, 15, whole);
    writeField<label>(io("material"), all, each, 16, whole);
    writeField<label>(io("flags"), all, each, 17, whole);
    if (folded.position != view.position)
    {
        writeField<vector>(io("place"), all, each, 18, three);
    }
    forAll(scalars, k)
    {
        struct ::dem_scalar_info info;
        dem_scalar_info(d, scalars[k], &info);
        writeField<scalar>(io(info.name), all, each, N_NUMBERS + k, one);
    }
}
