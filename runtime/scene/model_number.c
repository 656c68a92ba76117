/* A glTF's materials by numbers. Assimp counts materials as it meets them, and tells of each its name alone: names may be missing, or two the same. So
 * it is given the file with the materials' numbers for names.
 *     "materials": [{ "name": "Bark" }, {}]     becomes     "materials": [{ "name": "0" }, { "name": "1" }] */
#include "runtime/scene/model_number.h"
#include <cjson/cJSON.h>
#include <stdio.h>
#include <stdlib.h>

char *model_number_materials(const char *text, size_t size)
{
    char number[16], *made = NULL;
    int count = 0;
    cJSON *json = cJSON_ParseWithLength(text, size), *material;
    cJSON_ArrayForEach(material, cJSON_GetObjectItemCaseSensitive(json, "materials"))
    {
        snprintf(number, sizeof number, "%d", count++);
        if (!cJSON_IsObject(material))
            continue;
        cJSON_DeleteItemFromObjectCaseSensitive(material, "name");
        cJSON_AddStringToObject(material, "name", number);
    }
    if (count)
        made = cJSON_PrintUnformatted(json);
    cJSON_Delete(json);
    return made;
}

int model_material_number(const char *name)
{
    char *end;
    const long number = strtol(name, &end, 10);
    return end > name && !*end && number >= 0 && number < MODEL_NO_MATERIAL ? (int)number : MODEL_NO_MATERIAL;
}
