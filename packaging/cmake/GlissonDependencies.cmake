# Everything that Glisson builds on, found once and here. Components are named one by one: Debian's OpenCV highgui
# and VTK's Qt support are Qt 5 and must never be linked.
find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE) # before ITK, which brings a target of the same name
find_package(nlohmann_json 3.11 REQUIRED)
find_package(Qt6 6.4 REQUIRED COMPONENTS Core Gui Widgets Test LinguistTools)
find_package(VTK 9.1 REQUIRED COMPONENTS
  CommonCore CommonDataModel CommonExecutionModel CommonMath CommonTransforms CommonColor
  FiltersCore FiltersGeneral FiltersGeometry FiltersModeling FiltersSources FiltersExtraction
  IOCore IOGeometry IOLegacy IOXML IOImage
  ImagingCore
  InteractionStyle InteractionWidgets
  RenderingAnnotation RenderingCore RenderingFreeType RenderingOpenGL2)
find_package(ITK 5.2 REQUIRED COMPONENTS
  ITKCommon ITKIOImageBase ITKIOGDCM ITKGDCM ITKIONIFTI ITKIONRRD ITKIOMeta ITKIOVTK ITKImageFunction
  ITKImageGrid ITKImageIntensity ITKImageFeature ITKImageGradient ITKImageLabel ITKImageStatistics
  ITKSmoothing ITKThresholding ITKMathematicalMorphology ITKBinaryMathematicalMorphology
  ITKLabelMap ITKLevelSets ITKRegionGrowing ITKConnectedComponents ITKDistanceMap ITKFastMarching
  ITKCurvatureFlow ITKAnisotropicSmoothing ITKAntiAlias ITKBiasCorrection)
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  # Debian's ITK describes what GCC can, and stops every other compiler. Clang can all of it, and is told so first.
  find_path(GLISSON_ITK_HEADERS itk_compiler_detection.h HINTS ${ITK_INCLUDE_DIRS} REQUIRED)
  file(READ "${GLISSON_ITK_HEADERS}/itk_compiler_detection.h" detection)
  string(REPLACE "#  if ITK_COMPILER_IS_GNU\n" "#  if ITK_COMPILER_IS_Clang\n" detection "${detection}")
  file(READ "${GLISSON_ITK_HEADERS}/compilers/ITK_COMPILER_INFO_GNU_CXX.h" description)
  string(REPLACE "(__GNUC__ * 100 + __GNUC_MINOR__)" "1202" description "${description}")
  string(REPLACE "#    include \"compilers/ITK_COMPILER_INFO_GNU_CXX.h\"" "${description}" detection "${detection}")
  file(CONFIGURE OUTPUT "${CMAKE_BINARY_DIR}/itk_compiler_detection.h" CONTENT "${detection}" @ONLY)
  add_compile_options("$<$<COMPILE_LANGUAGE:CXX>:SHELL:-include ${CMAKE_BINARY_DIR}/itk_compiler_detection.h>")
endif()
find_package(OpenCV 4.6 REQUIRED COMPONENTS core imgproc imgcodecs calib3d aruco dnn features2d video videoio)
find_package(CGAL 5.5 REQUIRED)
find_package(embree 3.13 REQUIRED)
find_package(dlib REQUIRED)
find_package(OpenIGTLink 1.11 REQUIRED)
find_package(DCMTK 3.6.7 REQUIRED CONFIG)
find_package(SuiteSparse REQUIRED)
