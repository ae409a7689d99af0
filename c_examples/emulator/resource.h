/* Numbers of the dialogs, controls, menu commands and strings: for the resources and for the program. */
#ifndef RESOURCE_H
#define RESOURCE_H

/* Dialogs, menu, and the labels of the scene keys. */
#define IDD_TRAJECTORY 101
#define IDD_GENERAL 102
#define IDD_START 103
#define IDD_DISPLAY 104
#define IDD_MANOEUVRE 105
#define IDD_FAILURE 106
#define IDD_RECOMMEND 107
#define IDD_BUDGET 108
#define IDR_MENU 120
#define IDR_KEYS 121

/* Headings of groups: drawn bold. Any number of controls has this one. */
#define IDC_HEADING 900

/* Trajectory. */
#define IDC_SOURCE 1001
#define IDC_BUILTIN 1002
#define IDC_TAKE 1003
#define IDC_LOG 1004
#define IDC_BROWSE 1005
#define IDC_TITLE 1006
#define IDC_LATITUDE 1010
#define IDC_LONGITUDE 1011
#define IDC_HEIGHT 1012
#define IDC_SPEED 1013
#define IDC_COURSE 1014
#define IDC_ROLL 1015
#define IDC_PITCH 1016
#define IDC_REPEAT 1017
#define IDC_MANOEUVRES 1020
#define IDC_ADD 1021
#define IDC_EDIT 1022
#define IDC_REMOVE 1023
#define IDC_UP 1024
#define IDC_DOWN 1025
#define IDC_TRACK 1030
#define IDC_PROFILE 1031

/* General parameters and sensors. */
#define IDC_RATE 1101
#define IDC_HOURS 1102
#define IDC_EARTH 1103
#define IDC_GRAVITY 1104
#define IDC_SCHEME 1105
#define IDC_FRAME 1106
#define IDC_SUBSAMPLES 1107
#define IDC_UPDATES 1108
#define IDC_VERTICAL 1109
#define IDC_MODEL 1110
#define IDC_SIGNAL 1111
#define IDC_AXES 1112
#define IDC_SEED 1113
#define IDC_RUN 1114
#define IDC_SECTION 1120
#define IDC_PRESET 1121
#define IDC_EFFECTS 1123
#define IDC_EFFECT 1124
#define IDC_VALUE 1130 /* to 1138: a matrix row by row */
#define IDC_WORD 1140
#define IDC_UNIT 1141
#define IDC_SAME 1142
#define IDC_OFF 1143

/* Start of the INS, mounting, altimeter: three controls each, but for the altimeter. */
#define IDC_POSITION 1200
#define IDC_POSITION_SIGMA 1203
#define IDC_VELOCITY 1206
#define IDC_VELOCITY_SIGMA 1209
#define IDC_MISALIGNMENT 1212
#define IDC_MISALIGNMENT_SIGMA 1215
#define IDC_ALIGNMENT 1218
#define IDC_ARM 1220
#define IDC_BORESIGHT 1223
#define IDC_ARM_ERROR 1226
#define IDC_BORESIGHT_ERROR 1229
#define IDC_BARO_BIAS 1240
#define IDC_BARO_NOISE 1241
#define IDC_BARO_SIGMA 1242
#define IDC_BARO_TIME 1243
#define IDC_BARO_SCALE 1244
#define IDC_BARO_LAG 1245

/* Display. */
#define IDC_PLOT 1301
#define IDC_QUANTITY 1302
#define IDC_DATA2 1303
#define IDC_DATA1 1304
#define IDC_LOGARITHMIC 1305
#define IDC_AXIS 1306 /* to 1308 */
#define IDC_PACE 1311
#define IDC_PROGRESS 1312
#define IDC_VALUES 1313
#define IDC_PACE_LABEL 1314

/* A manoeuvre. */
#define IDC_KIND 1401
#define IDC_DURATION 1402
#define IDC_RAMP 1403
#define IDC_SPEED_CHANGE 1404
#define IDC_HEIGHT_CHANGE 1405
#define IDC_HEADING_CHANGE 1406
#define IDC_BANK 1407
#define IDC_TURNS 1408
#define IDC_CHANNEL 1410 /* six of each */
#define IDC_AMPLITUDE 1420
#define IDC_FREQUENCY 1430
#define IDC_PHASE 1440
#define IDC_MESSAGE 1450

/* A failure, and the studies. */
#define IDC_SENSOR 1501
#define IDC_SENSOR_AXIS 1502
#define IDC_FAILURE_SIZE 1503
#define IDC_DENSITY 1504
#define IDC_INTERVAL 1505
#define IDC_LENGTH 1506
#define IDC_PROBABILITY 1507
#define IDC_FAILING 1508
#define IDC_CLEAR 1509
#define IDC_SIZE_UNIT 1510
#define IDC_DENSITY_UNIT 1511
#define IDC_FROM 1600
#define IDC_TO 1601
#define IDC_LIMIT_POSITION 1602
#define IDC_LIMIT_VELOCITY 1603
#define IDC_LIMIT_ATTITUDE 1604
#define IDC_FOR 1605
#define IDC_RUNS 1606
#define IDC_RESULT 1607
#define IDC_STATE 1608
#define IDC_COMPUTE 1609
#define IDC_ADOPT 1610

/* Commands: of the menu, and buttons of the display. */
#define ID_NEW 2001
#define ID_OPEN 2002
#define ID_SAVE 2003
#define ID_SAVE_AS 2004
#define ID_EXPORT 2005
#define ID_PICTURE 2006
#define ID_COPY 2007
#define ID_QUIT 2008
#define ID_FLY 2010
#define ID_PAUSE 2011
#define ID_STOP 2012
#define ID_RESET 2013
#define ID_FAILURE 2014
#define ID_SNAPSHOT 2015
#define ID_GO_BACK 2016
#define ID_RECOMMEND 2017
#define ID_BUDGET 2018
#define ID_ENGLISH 2020
#define ID_CHINESE 2021
#define ID_ABOUT 2022
#define ID_PAGE 2030 /* to 2033 */
#define ID_RECENT 2100  /* to 2108 */
#define ID_BUILTIN 2200 /* and those that follow */

/* Strings. */
#define IDS_TITLE 3001
#define IDS_TABS 3002
#define IDS_SOURCES 3003
#define IDS_QUANTITIES 3004
#define IDS_PACES 3005
#define IDS_VALUES 3006
#define IDS_SECTIONS 3007
#define IDS_OFF 3008
#define IDS_COLUMNS_MANOEUVRES 3009
#define IDS_COLUMNS_EFFECTS 3010
#define IDS_COLUMNS_VALUES 3011
#define IDS_COLUMNS_BUDGET 3012
#define IDS_COLUMNS_RECOMMEND 3013
#define IDS_SAVE_CHANGES 3014
#define IDS_CANNOT_READ 3015
#define IDS_CANNOT_WRITE 3016
#define IDS_IS_INPUT 3017
#define IDS_NOT_VALID 3018
#define IDS_STATES 3019
#define IDS_PROGRESS 3020
#define IDS_NOTHING_FLOWN 3021
#define IDS_COMPUTING 3022
#define IDS_CANCELLED 3023
#define IDS_NEW_NAME 3024
#define IDS_FILTER_SCENE 3025
#define IDS_FILTER_LOG 3026
#define IDS_FILTER_CSV 3027
#define IDS_FILTER_PNG 3028
#define IDS_TIME 3029
#define IDS_AXES_ENU 3030
#define IDS_AXES_RPH 3031
#define IDS_AXES_XYZ 3032
#define IDS_TRACK 3033
#define IDS_HEIGHT_OVER_TIME 3034
#define IDS_DATA 3035
#define IDS_NO_FLIGHT 3036
#define IDS_PLOT_TIP 3037
#define IDS_ABOUT 3038
#define IDS_RECOMMEND_ROWS 3039
#define IDS_MET 3040
#define IDS_BUDGET_TOTAL 3041
#define IDS_SNAPSHOT_AT 3042
#define IDS_READY 3043
#define IDS_PRESET 3044
#define IDS_NOT_IN_FLIGHT 3045
#define IDS_TOO_LONG 3046

#endif
