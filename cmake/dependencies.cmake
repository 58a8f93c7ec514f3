# Finds every third party, with its lowest version, as an imported target. No other file finds packages.
find_package(PkgConfig REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)  # Eigen3::Eigen
find_package(fmt 9.1 REQUIRED)               # fmt::fmt
find_package(tomlplusplus 3.3 REQUIRED)      # tomlplusplus::tomlplusplus
find_package(nlohmann_json 3.11 REQUIRED)    # nlohmann_json::nlohmann_json
find_package(CLI11 2.1 REQUIRED)             # CLI11::CLI11
find_package(Ceres 2.1 REQUIRED)             # Ceres::ceres
find_package(Simbody 3.7 REQUIRED)           # thenar::simbody, below
find_package(SUNDIALS 6.4 REQUIRED COMPONENTS cvode kinsol)  # thenar::cvode, below
find_package(OpenSSL 3 REQUIRED COMPONENTS Crypto)  # OpenSSL::Crypto
find_package(assimp 5.2 REQUIRED)             # assimp::assimp
find_package(pugixml 1.12 REQUIRED)           # pugixml::pugixml
find_package(urdfdom REQUIRED)                # its targets carry no version
if(THENAR_TESTS OR THENAR_BENCH)
  find_package(fcl 0.7 REQUIRED)              # fcl
endif()
find_package(Boost 1.74 REQUIRED)             # Boost::headers
pkg_check_modules(NLOPT REQUIRED IMPORTED_TARGET nlopt_cxx>=2.7)       # PkgConfig::NLOPT
pkg_check_modules(CLP REQUIRED IMPORTED_TARGET clp>=1.17)              # PkgConfig::CLP
pkg_check_modules(QHULL REQUIRED IMPORTED_TARGET qhull_r>=8)           # PkgConfig::QHULL
pkg_check_modules(HDF5 REQUIRED IMPORTED_TARGET hdf5-serial>=1.10)     # PkgConfig::HDF5
pkg_check_modules(NETCDF REQUIRED IMPORTED_TARGET netcdf>=4.9)         # PkgConfig::NETCDF

add_library(thenar::simbody INTERFACE IMPORTED)
target_include_directories(thenar::simbody SYSTEM INTERFACE ${Simbody_INCLUDE_DIR})
target_link_libraries(thenar::simbody INTERFACE ${Simbody_LIBRARIES})

# Simbody exports the symbols of its own copy of SUNDIALS, which is 15 years older. Ours is linked statically
# with hidden symbols, so that neither calls the other. A source that includes its headers hides them, too
# (stiff_ode.cpp).
foreach(part cvode kinsol)
  add_library(thenar::${part} INTERFACE IMPORTED)
  target_link_libraries(thenar::${part} INTERFACE SUNDIALS::${part}_static)
  target_compile_definitions(thenar::${part} INTERFACE SUNDIALS_STATIC_DEFINE)
  target_link_options(thenar::${part} INTERFACE LINKER:--exclude-libs,libsundials_${part}.a)
endforeach()

# Ipopt's pkg-config file also links a MUMPS with a dummy MPI; the library alone is enough.
find_library(IPOPT_LIBRARY ipopt REQUIRED)
find_path(IPOPT_INCLUDE_DIR IpTNLP.hpp PATH_SUFFIXES coin REQUIRED)
add_library(thenar::ipopt INTERFACE IMPORTED)
target_include_directories(thenar::ipopt SYSTEM INTERFACE ${IPOPT_INCLUDE_DIR})
target_link_libraries(thenar::ipopt INTERFACE ${IPOPT_LIBRARY})
file(STRINGS ${IPOPT_INCLUDE_DIR}/IpoptConfig.h IPOPT_VERSION REGEX "define +IPOPT_VERSION +\"")
string(REGEX REPLACE ".*\"(.*)\".*" "\\1" IPOPT_VERSION "${IPOPT_VERSION}")

find_library(HDF5_HL_LIBRARY hdf5_serial_hl REQUIRED)  # dimension scales
add_library(thenar::hdf5 INTERFACE IMPORTED)
target_link_libraries(thenar::hdf5 INTERFACE ${HDF5_HL_LIBRARY} PkgConfig::HDF5)

# Link one BLAS: CHOLMOD calls libblas.so.3, which is OpenBLAS where it is installed. Debian's Ceres also
# links ATLAS, which is slower and would be found first.
get_target_property(libraries Ceres::ceres INTERFACE_LINK_LIBRARIES)
list(FILTER libraries EXCLUDE REGEX "lib(f77blas|atlas)[.]so")
set_target_properties(Ceres::ceres PROPERTIES INTERFACE_LINK_LIBRARIES "${libraries}")

find_library(CHOLMOD_LIBRARY cholmod REQUIRED)  # of SuiteSparse, which Ceres needs as well
find_path(CHOLMOD_INCLUDE_DIR suitesparse/cholmod.h REQUIRED)
add_library(thenar::cholmod INTERFACE IMPORTED)
target_include_directories(thenar::cholmod SYSTEM INTERFACE ${CHOLMOD_INCLUDE_DIR})
find_library(GOMP_LIBRARY NAMES libgomp.so.1 gomp REQUIRED)  # OpenMP's runtime that CHOLMOD uses
target_link_libraries(thenar::cholmod INTERFACE ${CHOLMOD_LIBRARY} ${GOMP_LIBRARY})

# Optional: meshes in VRML and Inventor, thenar::coin.
find_package(Coin 4.0 QUIET)
if(TARGET Coin::Coin)
  add_library(thenar::coin INTERFACE IMPORTED)
  target_link_libraries(thenar::coin INTERFACE Coin::Coin)
endif()

# Optional: chains across processes, thenar::mpi. Only the C library is linked, so that no Fortran MPI
# conflicts with the dummy one of Ipopt's sequential MUMPS.
set(MPI_CXX_SKIP_MPICXX TRUE)
find_package(MPI 3.1 QUIET COMPONENTS CXX)
if(MPI_CXX_FOUND)
  set(libraries ${MPI_CXX_LIBRARIES})
  list(FILTER libraries EXCLUDE REGEX "mpi_cxx|mpicxx|mpichcxx")
  add_library(thenar::mpi INTERFACE IMPORTED)
  target_include_directories(thenar::mpi SYSTEM INTERFACE ${MPI_CXX_INCLUDE_DIRS})
  target_compile_definitions(thenar::mpi INTERFACE ${MPI_CXX_COMPILE_DEFINITIONS})
  target_link_libraries(thenar::mpi INTERFACE ${libraries})
endif()

if(THENAR_TESTS)
  find_package(GTest 1.12 REQUIRED)  # GTest::gtest_main, GTest::gmock
  find_package(Python3 REQUIRED COMPONENTS Interpreter)
  # Use Debian's Python, which finds Debian's xarray even if another Python is first in PATH.
  find_program(DEBIAN_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH REQUIRED)
endif()
if(THENAR_BENCH)
  find_package(benchmark 1.7 REQUIRED)  # benchmark::benchmark_main
  find_library(MUJOCO_LIBRARY mujoco)  # optional: a rival, thenar::mujoco
  find_path(MUJOCO_INCLUDE_DIR mujoco/mujoco.h)
  if(MUJOCO_LIBRARY AND MUJOCO_INCLUDE_DIR)
    add_library(thenar::mujoco INTERFACE IMPORTED)
    target_include_directories(thenar::mujoco SYSTEM INTERFACE ${MUJOCO_INCLUDE_DIR})
    target_link_libraries(thenar::mujoco INTERFACE ${MUJOCO_LIBRARY})
  endif()
  # Optional: more of them, PkgConfig::ODE, PkgConfig::BULLET (in double precision) and thenar::dart.
  pkg_check_modules(ODE QUIET IMPORTED_TARGET ode>=0.16)
  pkg_check_modules(BULLET QUIET IMPORTED_TARGET bullet-float64>=3)
  find_library(DART_LIBRARY dart)
  find_path(DART_INCLUDE_DIR dart/dart.hpp)
  if(DART_LIBRARY AND DART_INCLUDE_DIR)
    add_library(thenar::dart INTERFACE IMPORTED)
    target_include_directories(thenar::dart SYSTEM INTERFACE ${DART_INCLUDE_DIR})
    target_link_libraries(thenar::dart INTERFACE ${DART_LIBRARY} fcl Eigen3::Eigen)
  endif()
  find_package(deal.II 9.4 QUIET)  # optional: a rival, by its own macro
endif()
