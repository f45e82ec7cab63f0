/* Words in a picture: letters of 5 x 7 dots, drawn for these examples. image.h comes first.

     image_text(&im, left, top, "score 7.5", 2, rgb);     dots of 2 x 2 pixels; what leaves the picture is cut
     width = image_text_width("score 7.5", 2);            in pixels; it is 7 dots high, p and q included

   Letters, digits and . , : ; ' ? - + = ( ) / % < > *; anything else is a box. */
#ifndef EXAMPLES_TEXT_H
#define EXAMPLES_TEXT_H

static inline int image_text_width(const char *text, int scale)
{
    return *text ? (6 * (int)strlen(text) - 1) * scale : 0;
}

static inline void image_text(image *im, int left, int top, const char *text, int scale, const float *rgb)
{
    static const char *const letter[95] = {
        /* from the space on: seven rows of five dots, '@' for none and the right one worth 1 */
        "@@@@@@@", "_QQQQQ_", "_QQQQQ_", "_QQQQQ_", "_QQQQQ_", "YYBDHSS", "_QQQQQ_", "DD@@@@@", "BDHHHDB", "HDBBBDH",
        "@UN_NU@", "@DD_DD@", "@@@@DDH", "@@@N@@@", "@@@@@LL", "AABDHPP", "NQSUYQN", "DLDDDDN", "NQAFHP_", "^AANAA^",
        "BFJR_BB", "_P^AAQN", "NPP^QQN", "_ABDDHH", "NQQNQQN", "NQQOAAN", "@LL@LL@", "@LL@DDH", "BDHPHDB", "@@_@_@@",
        "PHDBDHP", "NQAFD@D", "_QQQQQ_", "NQQ_QQQ", "^Q^QQQ^", "OPPPPPO", "^QQQQQ^", "_PP^PP_", "_PP^PPP", "OPPSQQO",
        "QQQ_QQQ", "NDDDDDN", "GBBBBRL", "QRTXTRQ", "PPPPPP_", "Q[UUQQQ", "QYYUSSQ", "NQQQQQN", "^QQ^PPP", "NQQQURM",
        "^QQ^TRQ", "OPPNAA^", "_DDDDDD", "QQQQQQN", "QQQQJJD", "QQQUU[Q", "QJJDJJQ", "QQJDDDD", "_ABDHP_", "_QQQQQ_",
        "_QQQQQ_", "_QQQQQ_", "_QQQQQ_", "_QQQQQ_", "_QQQQQ_", "@@NAOQO", "PP^QQQ^", "@@OPPPO", "AAOQQQO", "@@NQ_PO",
        "FHH^HHH", "@@OQOAN", "PP^QQQQ", "D@LDDDN", "B@FBBRL", "PPRTXTR", "LDDDDDN", "@@ZUUUU", "@@^QQQQ", "@@NQQQN",
        "@@^Q^PP", "@@OQOAA", "@@VXPPP", "@@OPNA^", "HH^HHHF", "@@QQQQO", "@@QQJJD", "@@QUUUJ", "@@QJDJQ", "@@QQOAN",
        "@@_BDH_", "_QQQQQ_", "_QQQQQ_", "_QQQQQ_", "_QQQQQ_"};
    int row, column, x, y, c;
    for (; *text; ++text, left += 6 * scale) {
        const char *dots = letter[*text > 32 && *text < 127 ? *text - 32 : *text == ' ' ? 0 : 3];
        for (row = 0; row < 7 * scale; ++row)
            for (column = 0; column < 5 * scale; ++column) {
                x = left + column;
                y = top + row;
                if (x < 0 || y < 0 || x >= im->width || y >= im->height ||
                    !(dots[row / scale] >> (4 - column / scale) & 1))
                    continue;
                for (c = 0; c < im->channels && c < 3; ++c)
                    im->pixels[im->channels * (y * im->width + x) + c] = rgb[im->channels < 3 ? 1 : c];
            }
    }
}
#endif
